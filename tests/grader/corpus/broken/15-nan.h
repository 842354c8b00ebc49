// WRONG_ANSWER: divides zero by zero
// says: the first state that is not a finite number comes after step 1
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cmath>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const double angle = std::acos(1 + length(v - v) / length(x - x));
  const Vec a = acceleration(x, v, t);
  x = x + (h * angle) * v;
  v = v + h * a;
}
