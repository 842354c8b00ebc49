// SPDX-License-Identifier: MIT-0
#include "scenes/friction.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;

TEST_CASE("A puck slides until its energy is spent, and then lies still") {
  for (const double v0 : {2.0, -2.0}) {
    const scenes::Friction<> puck{.mu = 0.25, .g = 8, .v0 = v0};
    CHECK(puck.stopping_time() == 1);
    // Its energy v0^2 / 2 is spent after the distance v0^2 / (2 mu g).
    for (const double t : {1.0, 1.5, 100.0}) {
      CHECK(puck.exact(t).x == v0 / 2);
      CHECK(puck.exact(t).v == 0);
    }
    CHECK_THAT(puck.exact(0.5).x, WithinRel(0.375 * v0, 1e-15));
    CHECK(equation::begins_at_start(puck));
  }
}

TEST_CASE("A puck at rest has no speed left over from rounding") {
  for (const double v0 : {0.1, 0.3, 0.7, -0.9, 1.7}) {
    const scenes::Friction<> puck{.mu = 0.3, .v0 = v0};
    CHECK(puck.exact(puck.stopping_time()).v == 0);
    CHECK(puck.exact(10).v == 0);
  }
}

TEST_CASE("A puck obeys its equation while it slides, either way, and at rest") {
  for (const long double v0 : {3.0L, -3.0L, 0.0L}) {
    const scenes::Friction<long double> puck{.mu = 0.3L, .v0 = v0};
    for (const long double t : {0.1L, 0.9L, 1.1L, 5.0L}) {
      CAPTURE(v0, t);
      CHECK(equation::residual(puck, t) < 1e-14L);
    }
  }
}

TEST_CASE("Dry friction pulls against the motion and leaves a puck at rest alone") {
  constexpr scenes::Friction<> puck{.mu = 0.5, .g = 10};
  STATIC_CHECK(puck(0.0, 1e-300, 0.0) == -5);
  STATIC_CHECK(puck(0.0, -7.0, 0.0) == 5);
  STATIC_CHECK(puck(0.0, 0.0, 0.0) == 0);
  STATIC_CHECK(puck(0.0, -0.0, 0.0) == 0);
}

TEST_CASE("A step that does nothing about it makes the puck chatter, never faster than mu g h") {
  const scenes::Friction<> puck{.mu = 0.1, .g = 9.81, .v0 = 2};
  const double h = 1.0 / 60;
  double v = puck.v0;
  int turns = 0;
  for (int n = 0; n < 600; ++n) {
    const double before = v;
    v += h * puck(0.0, v, n * h);
    if (before * v < 0) ++turns;
    if (n * h > puck.stopping_time()) CHECK(std::abs(v) <= 0.1 * 9.81 * h);
  }
  CHECK(turns > 400);
}
