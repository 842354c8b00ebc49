// fails: five steps under a hidden force are Euler's
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, 0);
  x += h * v;
  v += h * a;
}
