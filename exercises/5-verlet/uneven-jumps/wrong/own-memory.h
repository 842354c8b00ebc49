// Fails: a throw passes through its true places, whatever the frames
// Says: the length of the last frame is kept in the program, where that of another thing lies, and not taken from h_previous
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps the last frame itself, and so takes that of another object.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  static double last = h;
  const Vec v = (x - x_previous) / last;
  const Vec next = x + h * (v + (h + last) / 2 * acceleration(x, v, t));
  last = h;
  x_previous = x;
  x = next;
}

inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  const Vec before = (x - x_previous) / h_previous, after = (x_next - x) / h;
  return (h * before + h_previous * after) / (h_previous + h);
}
