// SPDX-License-Identifier: MIT-0
/// @file
/// A spring that has come to rest, and yet has not.
#pragma once
#include <cmath>

#include "measure/methods.h"
#include "measure/run.h"
#include "toys.h"

/// How long RK4 steps the suspension until its place is a number too small to be written with all
/// its digits [s].
inline double comes_to_rest() {
  auto s = suspension.start();
  long n = 0;
  while (std::fpclassify(s.x) == FP_NORMAL)
    measure::rk4(s.x, s.v, double(n++) * frame, frame, suspension);
  return double(n) * frame;
}

/// The suspension some time after that.
inline constexpr scenes::Spring<> at_rest{
    .omega = suspension.omega, .zeta = suspension.zeta, .x0 = 1e-309};
