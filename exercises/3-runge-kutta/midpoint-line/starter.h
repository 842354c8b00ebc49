// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of the midpoint method.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec x_middle = x + (h / 2) * v;
  const Vec v_middle = v + (h / 2) * acceleration(x, v, t);
  // Your line: where x is at the end of the step.
  v = v + h * acceleration(x_middle, v_middle, t + h / 2);
}
