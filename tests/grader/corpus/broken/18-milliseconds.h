// PARTIAL: takes the step for milliseconds
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + (h / 1000) * v;
  v = v + (h / 1000) * a;
}
