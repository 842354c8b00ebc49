// RUNTIME_ERROR: reserves room for two and never makes them, though the answer is right
// says: an index that is past the end of its vector
// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>

#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  std::vector<Vec> slopes;
  slopes.reserve(2);
  slopes[0] = v;
  slopes[1] = acceleration(x, v, t);
  x += h * slopes[0];
  v += h * slopes[1];
}
