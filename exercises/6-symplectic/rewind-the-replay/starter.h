// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of symplectic Euler, velocity first.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s], more than zero
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]; the velocity makes no difference
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  // Your two lines.
}

/// Takes that step back.
/// @param x  position after the step [m]; becomes the one before it
/// @param v  velocity after the step [m/s]; becomes the one before it
/// @param t  time at the start of the step that is taken back [s]
/// @param h  its size [s], more than zero
/// @param acceleration  as above
inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  // And two more.
}
