// PARTIAL: takes the step to be a thousand times as long
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + (1000 * h) * v;
  v = v + (1000 * h) * a;
}
