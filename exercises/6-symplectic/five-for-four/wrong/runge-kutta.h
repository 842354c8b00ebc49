// Fails: twenty steps there and twenty back lead home
// Says: this is RK4
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// RK4: order four, and no way home.
inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  const Vec v1 = v, a1 = acceleration(x, v, t);
  const Vec v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v1, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  a = a4;
}
