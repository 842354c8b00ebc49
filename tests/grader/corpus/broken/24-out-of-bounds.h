// RUNTIME_ERROR: writes outside of an array
// says: segmentation fault
// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  std::vector<double> memory(3);
  for (int n = 0; n < 100'000'000; ++n) memory.data()[n] = h;
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
