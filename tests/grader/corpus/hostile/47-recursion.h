// RUNTIME_ERROR: calls itself without end
// says: segmentation fault
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double deep(volatile double* above) {
  volatile double here[64] = {*above};
  return deep(here) + here[1];
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  volatile double start = 1;
  x.x = deep(&start);
}
