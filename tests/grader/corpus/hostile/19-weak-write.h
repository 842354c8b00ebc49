// INCOMPLETE|TIME_LIMIT|WRONG_ANSWER|PROTOCOL_ERROR|RUNTIME_ERROR|LINK_ERROR: replaces write behind the word inline
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

extern "C" __attribute__((used)) inline long write(int, const void*, unsigned long size) {
  return static_cast<long>(size);
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
