// SPDX-License-Identifier: MIT-0
#include "scenes/toss.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("A ball is pulled down by gravity alone, however fast it is") {
  const scenes::Toss ball(5);
  for (const double v : {-100.0, 0.0, 5.0}) CHECK(ball(2.0, v, 0.0) == -ball.g);
}

TEST_CASE("A ball keeps its energy, and is back in the hand as fast as it left") {
  const scenes::Toss ball(5);
  const auto start = ball.start();
  const double up = ball.energy(start.x, start.v);
  for (const double t : {0.1, 0.5, 2.0}) {
    const auto s = ball.exact(t);
    CHECK_THAT(ball.energy(s.x, s.v), WithinRel(up, 1e-13));
  }
  const auto back = ball.exact(2 * 5 / ball.g);
  CHECK_THAT(back.x, WithinAbs(0, 1e-14));
  CHECK_THAT(back.v, WithinRel(-5.0, 1e-14));
}
