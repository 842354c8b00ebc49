// RUNTIME_ERROR: has a large array on the stack
// says: segmentation fault
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  volatile char large[200'000'000];
  for (unsigned long n = 0; n < sizeof large; n += 4096) large[n] = 1;
}
