// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// From the middle on: half a step of the change is still to come.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const double half = h / 2;
  const Vec start = x, v_start = v;
  const Vec a = acceleration(x, v, t);
  x += half * v;
  v += half * a;
  const Vec a_middle = acceleration(x, v, t + half);
  x = start + h * v;
  v = v_start + h * a_middle;
}
