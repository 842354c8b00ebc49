// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec over(const Vec& from, const Vec& to, double h) {
  return (to - from) / h;
}

// The rest of the last frame's half, then the first half of this one.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  Vec v = over(x_previous, x, h_previous);
  const Vec a = acceleration(x, v, t);
  v += h_previous / 2 * a;
  v += h / 2 * a;
  x_previous = x;
  x += h * v;
}

// What the mean acceleration of the two frames adds to the velocity of the last one's middle.
inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  const Vec v_before = over(x_previous, x, h_previous), v_after = over(x, x_next, h);
  const Vec a = (v_after - v_before) / ((h_previous + h) / 2);
  return v_before + h_previous / 2 * a;
}
