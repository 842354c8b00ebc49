// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The slope of the middle, drawn through the two that are known.
inline void step(Vec& x, Vec& v, double t, double h, double alpha,
                 const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  const double ahead = alpha * h;
  const Vec change = acceleration(x + ahead * v, v + ahead * a, t + ahead) - a;
  x += h * v + 0.5 * h * h * a;
  v += h * a + 0.5 * h / alpha * change;
}
