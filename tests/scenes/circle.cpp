// SPDX-License-Identifier: MIT-0
#include "scenes/circle.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;
using Eigen::Vector2d;

// Taylor series of the differential equation: see reference.py.
TEST_CASE("The body on the circle is where its equation says") {
  const scenes::Circle<> circle{.omega = 1.5, .radius = 2};
  CHECK((circle.exact(0.9).x - Vector2d(0.43801337418608316284, 1.9514467156533181385)).norm() <
        1e-15);
  CHECK((circle.exact(0.9).v - Vector2d(-2.9271700734799772078, 0.65702006127912474426)).norm() <
        1e-15);
  CHECK((circle.exact(7).x - Vector2d(-0.95107385599198507105, -1.759391519943340196)).norm() <
        1e-15);
  CHECK((circle.exact(7).v - Vector2d(2.6390872799150102941, -1.4266107839879776066)).norm() <
        1e-15);
  CHECK(equation::begins_at_start(circle));
}

TEST_CASE("The body on the circle obeys its equation") {
  const scenes::Circle<long double> circle{.omega = 1.5L, .radius = 2};
  for (const long double t : {-3.0L, 0.2L, 4.0L, 30.0L}) {
    CHECK(equation::residual(circle, t) < 1e-13L);
  }
}

TEST_CASE("On the circle, distance, speed, energy and angular momentum stay") {
  const scenes::Circle<> circle{.omega = 1.5, .radius = 2};
  for (int n = 0; n < 100; ++n) {
    const auto now = circle.exact(0.37 * n);
    CHECK_THAT(now.x.norm(), WithinRel(2.0, 1e-15));
    CHECK_THAT(now.v.norm(), WithinRel(3.0, 1e-15));
    CHECK_THAT(circle.energy(now.x, now.v), WithinRel(9.0, 1e-15));
    CHECK_THAT(circle.angular_momentum(now.x, now.v), WithinRel(6.0, 1e-15));
  }
}

TEST_CASE("After its period the body on the circle is back") {
  const scenes::Circle<> circle{.omega = 1.5, .radius = 2};
  CHECK_THAT(circle.period(), WithinRel(4.18879020478639098, 1e-15));
  CHECK((circle.exact(circle.period()).x - circle.start().x).norm() < 1e-14);
  CHECK((circle.exact(circle.period() / 4).x - Vector2d(0, 2)).norm() < 1e-14);
}
