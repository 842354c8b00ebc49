// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const double third = h / 3;
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + third * a1;
  const Vec a2 = acceleration(x + third * v, v2, t + third);
  const Vec v3 = v - third * a1 + h * a2;
  const Vec a3 = acceleration(x - third * v + h * v2, v3, t + 2 * third);
  const Vec v4 = v + h * (a1 - a2 + a3);
  const Vec a4 = acceleration(x + h * (v - v2 + v3), v4, t + h);
  x += (v + v4) * (h / 8) + (v2 + v3) * (3 * h / 8);
  v += (a1 + a4) * (h / 8) + (a2 + a3) * (3 * h / 8);
}
