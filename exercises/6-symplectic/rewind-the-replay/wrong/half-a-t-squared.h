// fails: five steps under a hidden force are those of symplectic Euler
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += h * v + (h * h / 2) * a;
  v += h * a;
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x -= h * v;
  v -= h * acceleration(x, v, t);
}
