// fails: five steps under a hidden force are Euler's
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += h * v + (h * h / 2) * a;
  v += h * a;
}
