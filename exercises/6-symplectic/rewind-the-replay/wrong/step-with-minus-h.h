// fails: undone steps lead back to the start of the replay
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v += h * acceleration(x, v, t);
  x += h * v;
}

// The same lines with -h: they go back, but not to where the step came from.
inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  step(x, v, t + h, -h, acceleration);
}
