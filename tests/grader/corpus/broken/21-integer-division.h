// PARTIAL: divides integers
// says: never changes
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + (1 / 2 * 2) * h * v;
  v = v + (1 / 2 * 2) * h * a;
}
