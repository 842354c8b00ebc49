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

TEST_CASE("Velocity first, ten steps of n substeps fall by 50 + 5/n, position first by 50 - 5/n") {
  for (const int n : {1, 2, 3, 4, 8, 20}) {
    CHECK_THAT(fallen(measure::symplectic_euler, n), WithinRel(50 + 5.0 / n, 1e-12));
    CHECK_THAT(fallen(measure::symplectic_euler_position_first, n), WithinRel(50 - 5.0 / n, 1e-12));
  }
}

TEST_CASE(
    "A leaf falls too fast by g h / n if n substeps brake it first, and by g h (n + 1) / 2n if it "
    "is "
    "braked once at the end") {
  // What it moves in a second, far from the start
  const auto speed = [](int substeps, bool in_each) {
    const double h = frame / substeps, c = leaf.c;
    double v = 0, moved = 0;
    for (int n = 0; n < 2000; ++n) {
      moved = 0;
      for (int substep = 0; substep < substeps; ++substep) {
        v = (in_each ? v / (1 + c * h) : v) + h * leaf.g;
        moved += h * v;
      }
      if (!in_each) v = v / (1 + c * frame);
    }
    return moved / frame;
  };
  const double right = leaf.g / leaf.c;
  for (const int n : {1, 2, 4, 8}) {
    CHECK_THAT(speed(n, true) - right, WithinRel(leaf.g * frame / n, 1e-9));
    CHECK_THAT(speed(n, false) - right, WithinRel(leaf.g * frame * (n + 1) / (2 * n), 1e-9));
  }
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
