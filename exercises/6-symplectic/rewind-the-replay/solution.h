// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of symplectic Euler, velocity first.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v = v + h * acceleration(x, v, t);
  x = x + h * v;
}

/// Takes that step back: the drift first, so that the kick is found where it was given.
inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x = x - h * v;
  v = v - h * acceleration(x, v, t);
}
