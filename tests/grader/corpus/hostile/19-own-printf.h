// LINK_ERROR|COMPILE_ERROR: replaces printf
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

extern "C" int printf(const char*, ...) { return 0; }

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
