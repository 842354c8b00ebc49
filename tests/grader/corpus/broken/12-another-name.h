// COMPILE_ERROR: calls it Step
// says: step is missing
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void Step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
