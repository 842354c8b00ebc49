// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of order two that looks a share of the step ahead.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param alpha  how far it looks ahead, in steps: above 0, and 1 at most
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]
inline void step(Vec& x, Vec& v, double t, double h, double alpha,
                 const Acceleration& acceleration) {
  // Your step: look at the start and ahead, then move x and v.
}
