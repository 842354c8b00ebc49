// Fails: within the budget the shuttle lands as near as equal steps bring it
// Says: this is Euler's method in 1200 equal steps
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const double h = seconds / 1200;
  for (int n = 0; n < 1200; ++n) {
    const Vec a = acceleration(x, v, t + n * h);
    x += h * v;
    v += h * a;
  }
}
