// PARTIAL|WRONG_ANSWER: takes two steps instead of one
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (int n = 0; n < 2; ++n) {
    const Vec a = acceleration(x, v, t);
    x = x + h * v;
    v = v + h * a;
    t += h;
  }
}
