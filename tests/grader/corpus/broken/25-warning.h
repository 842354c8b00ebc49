// ACCEPTED: has a variable that it does not use
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  int unused;
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
