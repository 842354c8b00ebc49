// SPDX-License-Identifier: MIT-0
// Under a constant force, where every error can be worked out by hand.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "measure/run.h"
#include "scenes/projectile.h"

using Catch::Matchers::WithinRel;

namespace {

struct Misses {
  double up, sideways, speed;
};

// How far the cannonball of step h is from the true one after `steps` steps.
template <class Step>
Misses misses(Step step, double h, int steps) {
  const scenes::Projectile<> ball{.start_velocity = {3, 20}};
  const auto end = measure::after(step, ball, ball.start(), h, steps);
  const auto truth = ball.exact(steps * h);
  return {end.x.y() - truth.x.y(), end.x.x() - truth.x.x(), (end.v - truth.v).norm()};
}

}  // namespace

TEST_CASE("Under constant force Euler lags by a h t / 2, symplectic Euler leads by as much") {
  for (const double h : {1.0 / 60, 0.25}) {
    for (const int steps : {1, 7, 100}) {
      const double half = -9.81 * h * (steps * h) / 2;
      CAPTURE(h, steps);
      const Misses euler = misses(measure::euler, h, steps);
      CHECK_THAT(euler.up, WithinRel(-half, 1e-10));
      const Misses symplectic = misses(measure::symplectic_euler, h, steps);
      CHECK_THAT(symplectic.up, WithinRel(half, 1e-10));
      for (const Misses& miss : {euler, symplectic}) {
        CHECK(miss.speed < 1e-11);
        CHECK(std::abs(miss.sideways) < 1e-12);
      }
    }
  }
}

TEST_CASE("Under constant force the exact step is exact, however long it is") {
  for (const double h : {1.0 / 60, 0.25, 30.0}) {
    for (const int steps : {1, 7, 100}) {
      const Misses exact = misses(measure::constant_acceleration, h, steps);
      const double rounding = 1e-14 * 9.81 * (h * steps) * (h * steps);
      CAPTURE(h, steps, exact.up);
      CHECK(std::abs(exact.up) < rounding + 1e-12);
      CHECK(exact.speed < rounding + 1e-12);
    }
  }
}
