// SPDX-License-Identifier: MIT-0
// What a method may be called with: clocks of their own type, constants, steps back in time.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <type_traits>

#include "measure/run.h"
#include "scenes/pendulum.h"

using Catch::Matchers::WithinRel;

namespace {

template <class Step>
void check_that_clock_keeps_its_type(Step step) {
  // A float cannot tell this time from the next frame's.
  const double night = 8 * 3600 + 1.0 / 1024;
  float x = 1, v = 2;
  double seen = 0;
  step(x, v, night, 0.5f, [&seen](float, float, auto t) {
    static_assert(std::is_same_v<decltype(t), double>);
    seen = t;
    return 4.0f;
  });
  CHECK(seen == night);
  CHECK(v == 4);
}

template <class Step>
constexpr double after_two_steps(Step step) {
  double x = 1, v = 0;
  for (int n = 0; n < 2; ++n) {
    step(x, v, n * 0.5, 0.5, [](double at, double, double t) { return t - at; });
  }
  return x;
}

// Forward for two seconds and back again: how far from the start?
template <class Step>
double there_and_back(Step step, int steps) {
  const scenes::Pendulum<> pendulum;
  const double h = 2.0 / steps;
  double x = 1.2, v = 0.3;
  for (int n = 0; n < steps; ++n) step(x, v, n * h, h, pendulum);
  for (int n = steps; n > 0; --n) step(x, v, n * h, -h, pendulum);
  return std::abs(x - 1.2);
}

}  // namespace

TEST_CASE("The clock may be a double while everything else is a float") {
  check_that_clock_keeps_its_type(measure::euler);
  check_that_clock_keeps_its_type(measure::symplectic_euler);
  check_that_clock_keeps_its_type(measure::constant_acceleration);
}

TEST_CASE("The compiler can take the steps itself") {
  STATIC_CHECK(after_two_steps(measure::euler) == 0.75);
  STATIC_CHECK(after_two_steps(measure::symplectic_euler) == 0.4375);
  STATIC_CHECK(after_two_steps(measure::constant_acceleration) == 0.578125);
}

TEST_CASE("Backwards with a negative step the start is found again, up to the order") {
  CHECK_THAT(there_and_back(measure::euler, 2000) / there_and_back(measure::euler, 4000),
             WithinRel(2.0, 0.02));
  CHECK_THAT(there_and_back(measure::symplectic_euler, 2000) /
                 there_and_back(measure::symplectic_euler, 4000),
             WithinRel(2.0, 0.02));
  CHECK_THAT(there_and_back(measure::constant_acceleration, 2000) /
                 there_and_back(measure::constant_acceleration, 4000),
             WithinRel(2.0, 0.02));
}
