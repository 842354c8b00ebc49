// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The place from both changes at once: h (v + h a) is the new velocity's way.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += (v + a * h) * h;
  v += a * h;
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec start = x - v * h;
  v -= acceleration(start, v, t) * h;
  x = start;
}
