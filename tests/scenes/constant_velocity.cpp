// SPDX-License-Identifier: MIT-0
#include "scenes/constant_velocity.h"

#include <catch2/catch_test_macros.hpp>

#include "equation.h"

using Eigen::Vector2d;

TEST_CASE("A body that nothing pushes covers the same distance every second") {
  const scenes::ConstantVelocity<> puck{.start_position = {1, 2}, .start_velocity = {3, -0.5}};
  for (const double t : {-4.0, 0.0, 0.25, 8.0}) {
    CHECK(puck.exact(t).x == Vector2d(1 + 3 * t, 2 - 0.5 * t));
    CHECK(puck.exact(t).v == Vector2d(3, -0.5));
  }
  CHECK(equation::begins_at_start(puck));
}

TEST_CASE("Constant velocity is no acceleration, in any number of dimensions") {
  const scenes::ConstantVelocity<> puck;
  CHECK(puck(7.0, -3.0, 2.0) == 0.0);
  CHECK(puck(Vector2d(7, 8), Vector2d(-3, 4), 2.0) == Vector2d(0, 0));
}
