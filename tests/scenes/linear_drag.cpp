// SPDX-License-Identifier: MIT-0
#include "scenes/linear_drag.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "equation.h"

using Catch::Matchers::WithinRel;

// Taylor series of the differential equation: see reference.py.
TEST_CASE("A leaf falls through air as its equation says") {
  const scenes::LinearDrag<> leaf{.c = 0.7, .v0 = 3};
  CHECK_THAT(leaf.exact(0.4).x, WithinRel(0.3302359984945094425, 1e-14));
  CHECK_THAT(leaf.exact(0.4).v, WithinRel(-1.1551651989461566097, 1e-14));
  CHECK_THAT(leaf.exact(3).x, WithinRel(-20.713175633659213369, 1e-14));
  CHECK_THAT(leaf.exact(3).v, WithinRel(-11.930777056438550642, 1e-14));
  CHECK(equation::begins_at_start(leaf));
}

TEST_CASE("A leaf obeys its equation, with little drag and with much") {
  for (const long double c : {0.0L, 1e-9L, 1e-3L, 0.5L, 8.0L}) {
    const scenes::LinearDrag<long double> leaf{.c = c, .v0 = 3};
    for (const long double t : {-0.1L, 0.2L, 2.0L}) {
      CAPTURE(c, t);
      CHECK(equation::residual(leaf, t) < 1e-12L);
    }
  }
}

TEST_CASE("A leaf falls as in a vacuum when its drag fades") {
  const scenes::LinearDrag<> vacuum{.c = 0, .v0 = 3};
  CHECK(vacuum.exact(2).x == 3.0 * 2 - 9.81 * 2 * 2 / 2);
  CHECK(vacuum.exact(2).v == 3 - 9.81 * 2);
  for (const double c : {1e-4, 1e-8, 1e-12}) {
    const scenes::LinearDrag<> leaf{.c = c, .v0 = 3};
    // To first order in c, drag takes c (v0 t^2 / 2 - g t^3 / 6) off the height.
    const double less = c * (3.0 * 2 * 2 / 2 - 9.81 * 2 * 2 * 2 / 6);
    CHECK(std::abs(leaf.exact(2).x - (vacuum.exact(2).x - less)) < 10 * c * c + 1e-14);
  }
}

TEST_CASE("A leaf ends at its terminal speed, where it no longer accelerates") {
  const scenes::LinearDrag<> leaf{.c = 2};
  CHECK(leaf.terminal_speed() == 4.905);
  CHECK_THAT(leaf.exact(30).v, WithinRel(-4.905, 1e-15));
  CHECK(std::abs(leaf(0.0, -leaf.terminal_speed(), 0.0)) < 1e-15);
}
