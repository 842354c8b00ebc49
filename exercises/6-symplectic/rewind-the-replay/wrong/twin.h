// fails: five steps under a hidden force are those of symplectic Euler
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The twin, position first, and what undoes it.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x += h * v;
  v += h * acceleration(x, v, t + h);
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v -= h * acceleration(x, v, t + h);
  x -= h * v;
}
