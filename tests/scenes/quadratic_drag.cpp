// SPDX-License-Identifier: MIT-0
#include "scenes/quadratic_drag.h"

#include <Eigen/Core>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;

// Taylor series of the differential equation: see reference.py.
TEST_CASE("A skydiver falls from rest as the equation says") {
  const scenes::QuadraticDrag<> diver{.k = 0.3};
  CHECK_THAT(diver.exact(0.2).x, WithinRel(-0.19246723780291617436, 1e-14));
  CHECK_THAT(diver.exact(0.2).v, WithinRel(-1.8884714992679167669, 1e-14));
  CHECK_THAT(diver.exact(2).x, WithinRel(-9.1297794886233382773, 1e-14));
  CHECK_THAT(diver.exact(2).v, WithinRel(-5.706432501679599776, 1e-14));
  CHECK(equation::begins_at_start(diver));
}

TEST_CASE("A skydiver obeys the equation, at first and at the terminal speed") {
  const scenes::QuadraticDrag<long double> diver{.k = 0.3L};
  for (const long double t : {0.02L, 0.58L, 0.585L, 2.0L, 50.0L}) {
    CAPTURE(t);
    CHECK(equation::residual(diver, t) < 1e-13L);
  }
}

TEST_CASE("A skydiver falls as in a vacuum at first, and at the terminal speed for ever") {
  const scenes::QuadraticDrag<> diver{.k = 0.004};
  CHECK_THAT(diver.exact(1e-5).x, WithinRel(-9.81 * 1e-10 / 2, 1e-11));
  CHECK_THAT(diver.terminal_speed(), WithinRel(49.52272205765753, 1e-15));
  CHECK_THAT(diver.exact(1e6).v, WithinRel(-49.52272205765753, 1e-15));
  CHECK_THAT(diver.exact(1e6).x, WithinRel(-49.52272205765753e6 + std::log(2) / 0.004, 1e-15));
  CHECK(std::abs(diver(0.0, -diver.terminal_speed(), 0.0)) < 1e-14);
}

TEST_CASE("Quadratic drag acts against the motion, on a line, in the plane and in space") {
  const scenes::QuadraticDrag<> ball{.k = 0.5};
  CHECK(ball(0.0, 2.0, 0.0) == -9.81 - 2);
  CHECK(ball(0.0, -2.0, 0.0) == -9.81 + 2);
  const Eigen::Vector2d plane = ball(Eigen::Vector2d(1, 2), Eigen::Vector2d(3, -4), 0.0);
  CHECK(plane == Eigen::Vector2d(-7.5, 10 - 9.81));
  const Eigen::Vector3d space = ball(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(2, 3, 6), 0.0);
  CHECK(space == Eigen::Vector3d(-7, -10.5 - 9.81, -21));
}
