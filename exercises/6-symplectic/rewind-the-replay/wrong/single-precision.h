// fails: undone steps lead back to the start of the replay
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v += h * acceleration(x, v, t);
  x += h * v;
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const float dt = static_cast<float>(h);
  x -= dt * v;
  v -= dt * acceleration(x, v, t);
}
