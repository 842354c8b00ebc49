// RUNTIME_ERROR: a function that promises a value ends without one
// says: reached the end of a value-returning function
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec moved(const Vec& x, const Vec& v, double h) {
  if (h < 0) return x + h * v;
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = moved(x, v, h);
  v += h * a;
}
