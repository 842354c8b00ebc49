// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of symplectic Euler for a sledge, with drag divided.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; may be long
/// @param along  direction of the runners, of length 1
/// @param c_along  drag along the runners [1/s]; may be 0
/// @param c_across  drag in all directions across them [1/s]; may be 0
/// @param push  acceleration of all forces but the drag, callable `(x, v, t) -> Vec` [m/s^2]
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  // Push, brake, move.
}
