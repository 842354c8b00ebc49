// RUNTIME_ERROR: counts in an int until it has no next, and gives the right answer all the same
// says: a whole number too large for its type
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  int ticks = std::numeric_limits<int>::max();
  if (t < 1e9) ticks += 1;
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a + 0.0 * ticks * a;
}
