// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of Euler's method.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
