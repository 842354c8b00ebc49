// PROTOCOL_ERROR: answers more than was asked
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
  const double more[] = {1, 2, 3};
  (void)!write(3, more, sizeof more);
}
