// SPDX-License-Identifier: MIT-0
// The orders of what has no place in the list of general methods: position Verlet and BDF2 with
// uneven steps, the methods for a spring or a damping alone, and an estimate of an error.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "measure/methods.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"
#include "slopes.h"

using Catch::Matchers::WithinRel;

namespace {

// Each step in two: five eighths of it, then three.
struct LongAndShort {
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    const Real brief = Real(0.375) * h;
    return {s.x, integrate::stormer_verlet_start(s.x, s.v, Real(0), brief, scene)};
  }
  template <class Vec, class Real, class Scene>
  static void step(std::array<Vec, 2>& memory, Real t, Real h, const Scene& scene) {
    const Real lengthy = Real(0.625) * h, brief = Real(0.375) * h;
    integrate::stormer_verlet_uneven(memory[0], memory[1], t, lengthy, brief, scene);
    integrate::stormer_verlet_uneven(memory[0], memory[1], t + lengthy, brief, lengthy, scene);
  }
  template <class Vec, class Real, class Scene>
  static scenes::State<Vec> to_state(const std::array<Vec, 2>& memory, Real, Real h, const Scene&) {
    return {memory[0], integrate::stormer_verlet_velocity(memory[0], memory[1], Real(0.375) * h)};
  }
};

// The same for BDF2, with one solve and to the end.
template <bool to_the_end>
struct LongAndShortBdf2 {
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 4> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    const auto previous = integrate::bdf2_start(s.x, s.v, Real(0), Real(0.375) * h, scene);
    return {s.x, s.v, previous.x, previous.v};
  }
  template <class Vec, class Real, class Scene>
  static void step(std::array<Vec, 4>& memory, Real t, Real h, const Scene& scene) {
    const Real lengthy = Real(0.625) * h, brief = Real(0.375) * h;
    part(memory, t, lengthy, brief, scene);
    part(memory, t + lengthy, brief, lengthy, scene);
  }
  template <class Vec, class Real, class Scene>
  static void part(std::array<Vec, 4>& memory, Real t, Real h, Real h_previous,
                   const Scene& scene) {
    const auto solve = measure::solver_of(scene);
    integrate::Bdf2Previous<Vec> previous{memory[2], memory[3]};
    if constexpr (to_the_end) {
      const auto size = [](const Vec& y) { return Real(measure::length(y)); };
      REQUIRE(integrate::bdf2_newton(memory[0], memory[1], previous, t, h, h_previous, scene, solve,
                                     size, Real(1e-13)) > 0);
    } else {
      REQUIRE(integrate::bdf2(memory[0], memory[1], previous, t, h, h_previous, scene, solve));
    }
    memory = {memory[0], memory[1], previous.x, previous.v};
  }
  template <class Vec, class Real, class Scene>
  static scenes::State<Vec> to_state(const std::array<Vec, 4>& memory, Real, Real, const Scene&) {
    return {memory[0], memory[1]};
  }
};

// A scene with an exact solution as a problem to measure orders on.
template <class Scene>
order::Problem<double, Scene> problem(const Scene& scene, double part) {
  std::array<scenes::State<double>, 8> truth;
  for (std::size_t n = 0; n < 8; ++n) truth[n] = scene.exact(double(n + 1) * part);
  return {scene, scene.start(), part, truth, {0, 200, 30, 0, 12, 12}};
}

const auto spring = problem(scenes::Spring<>{.omega = 2, .zeta = 0.3, .x0 = 0.3, .v0 = 1.1}, 0.45);

}  // namespace

TEST_CASE("With long and short steps in turn, position Verlet has its orders still") {
  order::check(LongAndShort(), order::pendulum<double>(), 2, 1);
  order::check(LongAndShort(), order::driven<double>(0.45), 2, 1);
  order::check(LongAndShort(), order::pushed<double>(), 1, 1);
}

TEMPLATE_TEST_CASE("With long and short steps in turn, BDF2 has order 2 in position and velocity",
                   "", LongAndShortBdf2<false>, LongAndShortBdf2<true>) {
  order::check(TestType(), order::pendulum<double>(), 2, 2);
  order::check(TestType(), order::kepler<double>(), 2, 2);
  order::check(TestType(), order::driven<double>(0.45), 2, 2);
  order::check(TestType(), order::pushed<double>(), 2, 2);
}

TEST_CASE("On a damped spring, implicit Euler by formula has order 1 and RK4's matrix order 4") {
  order::check(measure::backward_euler_spring, spring, 1, 1);
  order::check(measure::rk4_linear, spring, 4, 4);
}

TEMPLATE_LIST_TEST_CASE("On a damped spring, every way to damp has order 1", "", list::Damping) {
  order::check(TestType(), spring, 1, 1);
}

TEMPLATE_LIST_TEST_CASE("Falling through air, every way to damp has order 1, or is exact", "",
                        list::Damping) {
  const scenes::LinearDrag<> leaf{.c = 0.75, .v0 = 3};
  if (std::is_same_v<TestType, measure::LinearDampingExact>) {
    for (const double h : {1e-3, 0.5, 40.0}) {
      const auto end = measure::after(TestType(), leaf, leaf.start(), h, 3);
      CHECK_THAT(end.v, WithinRel(leaf.exact(3 * h).v, 1e-14));
    }
  } else {
    order::check(TestType(), problem(leaf, 0.25), 1, 1);
  }
}

TEST_CASE("Dormand and Prince's estimate is of order 4 and more than the error of its step") {
  double before = NAN;
  for (double h = 1.0 / 8; h > 1.0 / 100; h /= 2) {
    double x = spring.start.x, v = spring.start.v, a = spring.scene(x, v, 0.0);
    const auto error = integrate::dopri5(x, v, a, 0.0, h, spring.scene);
    const double estimate = std::hypot(error.x, error.v);
    const auto truth = spring.scene.exact(h);
    CHECK(std::hypot(x - truth.x, v - truth.v) < estimate);
    if (h < 1.0 / 8) CHECK(std::abs(std::log2(before / estimate) - 5) < 0.1);  // in a single step
    before = estimate;
  }
}
