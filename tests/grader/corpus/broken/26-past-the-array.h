// RUNTIME_ERROR: writes to a third of two vectors, and gives the right answer all the same
// says: an index past the end of an array
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  Vec slopes[2];
  const Vec a = acceleration(x, v, t);
  const int last = t < 1e9 ? 2 : 1;
  for (int i = 0; i <= last; ++i) slopes[i] = i == 1 ? a : v;
  x += h * slopes[0];
  v += h * slopes[1];
}
