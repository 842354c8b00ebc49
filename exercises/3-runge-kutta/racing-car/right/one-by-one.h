// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const double half = 0.5 * h;
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + half * a1;
  const Vec a2 = acceleration(x + half * v, v2, t + half);
  const Vec v3 = v + half * a2;
  const Vec a3 = acceleration(x + half * v2, v3, t + half);
  const Vec v4 = v + h * a3;
  const Vec a4 = acceleration(x + h * v3, v4, t + h);
  x += (v + v4) * (h / 6) + (v2 + v3) * (h / 3);
  v += (a1 + a4) * (h / 6) + (a2 + a3) * (h / 3);
}
