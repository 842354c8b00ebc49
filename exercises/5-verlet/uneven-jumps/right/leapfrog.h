// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec velocity(const Vec& from, const Vec& to, double h) {
  return (to - from) / h;
}

// The rest of the last frame's half, then the first half of this one.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  Vec v = velocity(x_previous, x, h_previous);
  const Vec a = acceleration(x, v, t);
  v += h_previous / 2 * a;
  v += h / 2 * a;
  x_previous = x;
  x += h * v;
}
