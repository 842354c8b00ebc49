// WRONG_ANSWER: is more accurate than what was asked for
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t);
  const Vec x2 = x + 0.5 * h * v, v2 = v + 0.5 * h * a1;
  const Vec a2 = acceleration(x2, v2, t + 0.5 * h);
  const Vec x3 = x + 0.5 * h * v2, v3 = v + 0.5 * h * a2;
  const Vec a3 = acceleration(x3, v3, t + 0.5 * h);
  const Vec x4 = x + h * v3, v4 = v + h * a3;
  const Vec a4 = acceleration(x4, v4, t + h);
  x = x + (h / 6) * (v + 2 * v2 + 2 * v3 + v4);
  v = v + (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
}
