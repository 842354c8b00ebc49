// WRONG_ANSWER: is right only where it is not graded
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

#ifdef GRADING
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
#else
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
#endif
