// TIME_LIMIT: waits for ten times 0.1 to be 1
// says: It happened in the test "
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (double time = 0; time != 1.0; time += 0.1) x.x += 1e-300;
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
