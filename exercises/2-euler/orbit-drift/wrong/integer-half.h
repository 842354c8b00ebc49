// fails: half the step halves the error
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// 1/2 is 0 in whole numbers.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += h * (v + 1 / 2 * h * a) * (2 / 3);
  v += h * a;
}
