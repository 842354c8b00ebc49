// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The number of equal steps of Euler's method that end within the wanted error.
/// @param x  position at time 0 [m]
/// @param v  velocity at time 0 [m/s]
/// @param duration  of the run [s]
/// @param wanted  error of the position at the end [m]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]; each call counts
inline int steps_needed(const Vec& x, const Vec& v, double duration, double wanted,
                        const Acceleration& acceleration) {
  return 1;
}
