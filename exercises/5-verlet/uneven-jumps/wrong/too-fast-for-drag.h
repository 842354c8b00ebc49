// Fails: six frames under a hidden force are those of the corrected formula
// Says: this is the right formula with a drag that sees the last distance over h, not over h_previous
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The last distance over the wrong frame: without drag nobody sees it.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h;
  const Vec next =
      x + h / h_previous * (x - x_previous) + h * (h + h_previous) / 2 * acceleration(x, v, t);
  x_previous = x;
  x = next;
}

inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  const Vec before = (x - x_previous) / h_previous, after = (x_next - x) / h;
  return (h * before + h_previous * after) / (h_previous + h);
}
