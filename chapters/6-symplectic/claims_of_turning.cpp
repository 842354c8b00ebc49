// SPDX-License-Identifier: MIT-0
// The claims of chapter 6 about things that turn.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "tumbling.h"

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE(
    "Turned by its spin at the start of each step a thrown body has twice its energy after ten "
    "seconds") {
  CHECK_THAT(energy_after_ten_seconds(measure::by_its_spin), WithinRel(2, 0.01));
  // All of it is in the axis of the smallest moment, and none can be added.
  measure::Tumbling body;
  for (int n = 0; n < 600; ++n) measure::by_its_spin(body, frame);
  const auto own = shelf::rotate_back(body.q, body.L);
  CHECK(std::abs(own.x) > 0.999 * std::sqrt(dot(body.L, body.L)));
}

TEST_CASE("Bullet's gyroscopic step takes 88 per cent of a thrown body's energy in ten seconds") {
  CHECK_THAT(energy_after_ten_seconds(measure::by_bullet), WithinAbs(0.12, 0.01));
}

TEST_CASE(
    "Rotations turn a thrown body ten times nearer than the midpoint rule, and both keep its "
    "energy to a thousandth") {
  CHECK(measure::off_in_a_second(measure::by_midpoint) >
        10 * measure::off_in_a_second(measure::by_rotations));
  CHECK_THAT(energy_after_ten_seconds(measure::by_midpoint), WithinRel(1, 1e-3));
  CHECK_THAT(energy_after_ten_seconds(measure::by_rotations), WithinRel(1, 1e-3));
}
