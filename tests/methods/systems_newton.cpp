// SPDX-License-Identifier: MIT-0
// How many iterations Newton's method takes, and how near they bring it.
#include <Eigen/Core>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "integrate/band_system.h"
#include "scenes/chain.h"
#include "scenes/rope.h"
#include "systems_steps.h"
#include "systems_try.h"

using namespace systems;

namespace {

const scenes::Chain<> chain_of_twenty{.count = 20, .mass = 0.5, .tip = 3, .k = 4000, .c = 20};
const scenes::Rope<> rope_of_twelve{.count = 12, .tip = 0.2, .k = 200, .c = 0.3};

template <int Width, class Scene>
auto band_of(const Scene& scene) {
  return integrate::BandSystem<Width, decltype(jacobian_of(scene))>(jacobian_of(scene));
}

}  // namespace

TEMPLATE_TEST_CASE("On a linear force Newton's method is done with the first iteration", "", Newton,
                   TrapezoidNewton, Bdf2Newton) {
  auto solve = band_of<1>(chain_of_twenty);
  auto [x, v] = chain_of_twenty.start();
  for (int n = 0; n < 20; ++n) {
    // The second one is there to see that there is nothing left but rounding: at most of speeds of
    // 10 m/s, times the condition of the matrix, which is below a thousand.
    CHECK(TestType::step(x, v, 0.05, chain_of_twenty, solve, 1e-11) <= 2);
  }
  auto [x_loose, v_loose] = chain_of_twenty.start();
  CHECK(TestType::step(x_loose, v_loose, 0.05, chain_of_twenty, solve, 1e3) == 1);
}

TEMPLATE_TEST_CASE("On a force that is not linear Newton's method doubles its digits", "", Newton,
                   TrapezoidNewton, Bdf2Newton) {
  double x_exact = 1.5, v_exact = -0.25;
  REQUIRE(TestType::step(x_exact, v_exact, 0.5, cubic, solve_cubic, 1e-14) > 0);
  int before = 0;
  for (const double tolerance : {1e-1, 1e-3, 1e-6}) {
    double x = 1.5, v = -0.25;
    const int iterations = TestType::step(x, v, 0.5, cubic, solve_cubic, tolerance);
    CAPTURE(tolerance, iterations);
    CHECK(iterations >= before);
    CHECK(iterations <= 6);
    // Its last change was within the tolerance; the error is about the square of that.
    CHECK(std::abs(v - v_exact) < 2 * tolerance * tolerance);
    before = iterations;
  }
}

TEMPLATE_TEST_CASE("On a rope in the air each implicit step can be solved", "", Once, Newton,
                   TrapezoidOnce, TrapezoidNewton, Bdf2Once, Bdf2Newton) {
  auto solve = band_of<5>(rope_of_twelve);
  auto [x, v] = rope_of_twelve.start();
  for (int n = 0; n < 60; ++n)
    REQUIRE(TestType::step(x, v, 1.0 / 60, rope_of_twelve, solve, 1e-6) > 0);
  CHECK(x.allFinite());
}
