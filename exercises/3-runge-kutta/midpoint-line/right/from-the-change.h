// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec gained = acceleration(x, v, t) * (0.5 * h);
  const Vec x_middle = x + 0.5 * h * v;
  const Vec v_middle = gained + v;
  v += acceleration(x_middle, v_middle, t + 0.5 * h) * h;
  x += h * v_middle;
}
