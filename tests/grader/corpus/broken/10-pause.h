// RUNTIME_ERROR: waits for a key
// says: not allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdlib>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
  std::system("pause");
}
