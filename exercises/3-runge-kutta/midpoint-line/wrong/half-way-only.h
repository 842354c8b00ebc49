// fails: five steps under a hidden force are the midpoint method's
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec x_middle = x + (h / 2) * v;
  const Vec v_middle = v + (h / 2) * acceleration(x, v, t);
  x = x + (h / 2) * v_middle;
  v = v + h * acceleration(x_middle, v_middle, t + h / 2);
}
