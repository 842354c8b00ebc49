// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of Euler's method.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  // Your two or three lines.
}

/// The fewest equal steps of Euler's method that take the drone once around its circle and not too
/// far out.
/// @param growth  share by which its distance from the tower may grow in the turn: 0.01 is 1 %;
/// from a
///   thousandth to 4
inline int steps_per_turn(double growth) {
  return 0;
}
