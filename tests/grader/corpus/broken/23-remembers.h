// PARTIAL|WRONG_ANSWER: is right only the first time
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline int calls = 0;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
  if (++calls > 1) x = x + 1e-3 * v;
}
