// TIME_LIMIT: is slower than it may be
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  volatile double wasted = 0;
  for (long n = 0; n < 20'000'000'000; ++n) wasted = wasted + 1;
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
