// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of velocity Verlet.
/// @param a  acceleration at the start, replaced by the one at the end
inline void verlet(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  v += h / 2 * a;
  x += h * v;
  a = acceleration(x, v, t + h);
  v += h / 2 * a;
}

/// One step of order four, from five of velocity Verlet.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param a  acceleration at the start [m/s^2], replaced by the one at the end
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]; the velocity makes no difference
inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  // Two forward, one back, two forward.
}
