// SPDX-License-Identifier: MIT-0
#include "scenes/projectile.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;
using Eigen::Vector2d;

TEST_CASE("A cannonball flies as far as the range formula says, and lands as fast as it left") {
  const scenes::Projectile<> ball{.start_velocity = {30, 40}};
  const double landing = 2 * 40 / 9.81;
  const auto end = ball.exact(landing);
  // The range of a shot at v0 and angle alpha is v0^2 sin(2 alpha) / g, here 50^2 * 0.96 / g.
  CHECK_THAT(end.x.x(), WithinRel(2400 / 9.81, 1e-14));
  CHECK(std::abs(end.x.y()) < 1e-12);
  CHECK_THAT(end.v.norm(), WithinRel(50.0, 1e-14));
}

TEST_CASE("A cannonball obeys its equation and keeps its energy") {
  const scenes::Projectile<long double> ball{.start_velocity = {3, 7}, .g = 1.62L};
  for (const long double t : {-1.0L, 0.3L, 5.0L}) {
    CHECK(equation::residual(ball, t) < 1e-14L);
    const auto now = ball.exact(t);
    CHECK(std::abs(ball.energy(now.x, now.v) - 29) < 1e-15L);
  }
  CHECK(equation::begins_at_start(ball));
}
