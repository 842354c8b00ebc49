// fails: a spring swings on while h omega is less than two, and no longer
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Euler's method: moves with the old velocity.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a;
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x -= h * v;
  v -= h * a;
}
