// SPDX-License-Identifier: MIT-0
/// @file
/// What the claims of the page ask for again and again.
#pragma once
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "sketch.h"

/// To what is printed, within half a unit of its last digit.
inline void rounds(double found, double said, double unit) {
  CHECK_THAT(found, Catch::Matchers::WithinAbs(said, 0.5001 * unit));
}

/// It leaves every picture.
inline void wild(const Line& line, double beyond) {
  CHECK(std::max(line.most(), -line.least()) > beyond);
}
