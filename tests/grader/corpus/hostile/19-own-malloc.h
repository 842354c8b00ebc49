// LINK_ERROR: replaces malloc
// says: is a function of C
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

extern "C" void* malloc(unsigned long) { return nullptr; }

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
