// fails: a drone on a circle gains only the energy that the midpoint method gives it
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// 1/2 is 0 in whole numbers.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec v_middle = v + 1 / 2 * h * acceleration(x, v, t);
  const Vec x_middle = x + 1 / 2 * h * v;
  x = x + h * v_middle;
  v = v + h * acceleration(x_middle, v_middle, t + h / 2);
}
