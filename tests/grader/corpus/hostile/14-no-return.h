// COMPILE_ERROR|WRONG_ANSWER|LINK_ERROR|ACCEPTED: defines return and const away
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

#define return
#define const

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
