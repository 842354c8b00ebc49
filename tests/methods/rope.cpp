// SPDX-License-Identifier: MIT-0
#include "scenes/rope.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include "integrate/backward_euler.h"
#include "integrate/band_system.h"
#include "integrate/trapezoid.h"

namespace {

// Let go straight and level, a rope of half a kilogram swings down: stiff, and nothing but linear.
const scenes::Rope<> rope{.count = 51, .c = 0.1};

// What gravity can give it: all of its mass as far down as its length.
const double available = rope.masses().sum() / 3 * rope.g * rope.length;

// The largest energy in twenty seconds at sixty steps a second [J]; at the start it is none.
template <class Step>
double most_energy(Step step) {
  auto [x, v] = rope.start();
  const auto jacobian = [](const auto& position, const auto& velocity, double t, auto&& add) {
    rope.jacobian(position, velocity, t, add);
  };
  integrate::BandSystem<5, decltype(jacobian)> system(jacobian);
  double most = 0;
  for (int n = 0; n < 1200; ++n) {
    REQUIRE(step(x, v, n / 60.0, 1 / 60.0, system));
    most = std::max(most, rope.energy(x, v));
  }
  return most;
}

}  // namespace

TEST_CASE("One solve of the trapezoid rule explodes on a rope that swings, backward Euler's no") {
  const double made_up = most_energy([](auto& x, auto& v, double t, double h, auto& system) {
    return integrate::trapezoid(x, v, t, h, rope, system);
  });
  CHECK(made_up > 10 * available);
  const double gained = most_energy([](auto& x, auto& v, double t, double h, auto& system) {
    return integrate::backward_euler(x, v, t, h, rope, system);
  });
  CHECK(gained < 0.01 * available);
}
