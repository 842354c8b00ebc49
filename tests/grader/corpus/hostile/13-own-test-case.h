// COMPILE_ERROR|LINK_ERROR: registers a test of its own
// SPDX-License-Identifier: MIT-0
#pragma once
#include <catch2/catch_test_macros.hpp>
#include "given.h"

TEST_CASE("five steps under a hidden force are Euler's", "[2-euler/orbit-drift][4 points]") {
  SUCCEED();
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
