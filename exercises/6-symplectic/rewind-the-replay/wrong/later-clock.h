// fails: an undo asks once, at the place and time where its step asked
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v += h * acceleration(x, v, t);
  x += h * v;
}

// The right places, at the time after the step.
inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x -= h * v;
  v -= h * acceleration(x, v, t + h);
}
