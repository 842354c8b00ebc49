// COMPILE_ERROR: has no time
// says: wanted is void step(Vec&, Vec&, double, double,
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, 0);
  x = x + h * v;
  v = v + h * a;
}
