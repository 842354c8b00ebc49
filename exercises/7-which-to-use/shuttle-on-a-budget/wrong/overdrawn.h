// Fails: within the budget the shuttle lands as near as equal steps bring it
// Says: it asked 12000 times, where 1200 are allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Near enough, and ten times as dear.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const double h = seconds / 3000;
  for (int n = 0; n < 3000; ++n) rk4(x, v, t + n * h, h, acceleration);
}
