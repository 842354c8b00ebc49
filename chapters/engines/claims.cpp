// SPDX-License-Identifier: MIT-0
// The claims of the page of the engines.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "drop.h"
#include "integrate/stormer_verlet.h"
#include "measure/methods.h"

using Catch::Matchers::WithinRel;

TEST_CASE("Ten steps of free fall tell velocity first from the exact step and position first") {
  CHECK_THAT(fallen(measure::symplectic_euler), WithinRel(55, 1e-12));
  CHECK_THAT(fallen(measure::backward_euler_newton), WithinRel(55, 1e-9));
  CHECK_THAT(fallen(measure::velocity_verlet), WithinRel(50, 1e-12));
  CHECK_THAT(fallen(measure::rk4), WithinRel(50, 1e-12));
  CHECK_THAT(fallen(measure::symplectic_euler_position_first), WithinRel(45, 1e-12));
  CHECK_THAT(fallen(measure::euler), WithinRel(45, 1e-12));
}

TEST_CASE("Verlet begun with the last place equal to the first falls by 55, begun right by 50") {
  constexpr scenes::LinearDrag<> fall{.c = 0};
  const auto falls = [&](double previous) {
    double x = 0, x_previous = previous;
    for (int n = 0; n < 10; ++n) integrate::stormer_verlet(x, x_previous, n * frame, frame, fall);
    return -x / (fall.g * frame * frame);
  };
  CHECK_THAT(falls(0), WithinRel(55, 1e-12));
  CHECK_THAT(falls(-fall.g * frame * frame / 2), WithinRel(50, 1e-12));
}
