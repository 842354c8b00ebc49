// SPDX-License-Identifier: MIT-0
#include "measure/stability.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <utility>

#include "measure/methods/euler.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;
using measure::euler;
using scenes::LinearDrag;
using scenes::Spring;

TEST_CASE("The growth of Euler on a spring is what its eigenvalues say") {
  // Without damping they are 1 + i h omega and 1 - i h omega.
  CHECK_THAT(measure::spectral_radius(euler, Spring<>{.omega = 3}, 0.25),
             WithinRel(std::sqrt(1 + 0.5625), 1e-14));
  // At zeta = 1.25 the rates are omega / 2 and 2 omega, and the larger of 1 - h / 2 and 2 h - 1 is
  // the factor.
  CHECK_THAT(measure::spectral_radius(euler, Spring<>{.zeta = 1.25}, 0.5), WithinRel(0.75, 1e-14));
  CHECK_THAT(measure::spectral_radius(euler, Spring<>{.zeta = 1.25}, 1.5), WithinRel(2.0, 1e-14));
  // On drag alone, the position stays where it is.
  CHECK_THAT(measure::spectral_radius(euler, LinearDrag<>{.c = 1, .g = 0}, 3.0),
             WithinRel(2.0, 1e-14));
}

TEST_CASE("Bisection finds the limits of Euler on a damped spring") {
  for (const auto& [zeta, limit] : {std::pair{0.1, 0.2}, {0.5, 1.0}, {2.0, 4 - 2 * std::sqrt(3)}}) {
    const Spring<> spring{.omega = 5, .zeta = zeta};
    CHECK_THAT(5 * measure::stability_limit(euler, spring, 1e-6, 1.0), WithinRel(limit, 1e-9));
  }
}

TEST_CASE("A limit in three digits is none that a step as long would pass") {
  for (const auto& [limit, written] : {std::pair{1.1683, 1.16},
                                       {2.8284271247461903, 2.82},
                                       {1.9999999999999993, 2.0},
                                       {0.99999999, 1.0},
                                       {0.082999, 0.0829},
                                       {33.17, 33.1}})
    CHECK_THAT(measure::in_three_digits(limit), WithinRel(written, 1e-12));
  CHECK(measure::in_three_digits(0) == 0);
  CHECK(std::isinf(measure::in_three_digits(INFINITY)));
}
