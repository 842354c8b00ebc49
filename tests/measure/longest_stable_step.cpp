// SPDX-License-Identifier: MIT-0
#include "measure/longest_stable_step.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "measure/methods/euler.h"
#include "measure/methods/implicit.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"

using Catch::Matchers::WithinRel;

TEST_CASE("The longest stable step of Euler on drag is two time constants") {
  const scenes::LinearDrag<> brake{.c = 1, .g = 0};
  CHECK_THAT(measure::longest_stable_step(measure::euler, brake), WithinRel(2, 1e-9));
  CHECK(measure::is_stable(measure::euler, brake, 1.99));
  CHECK_FALSE(measure::is_stable(measure::euler, brake, 2.01));
}

TEST_CASE(
    "What no step holds has a longest stable step of zero, and what all hold an endless one") {
  const scenes::Spring<> spring;
  CHECK(measure::longest_stable_step(measure::euler, spring) == 0);
  CHECK(std::isinf(measure::longest_stable_step(measure::backward_euler, spring)));
}
