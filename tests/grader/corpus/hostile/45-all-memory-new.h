// MEMORY_LIMIT: takes all memory and touches a part of it, with new
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) {
    volatile char* some = new char[1 << 24];
    some[0] = 1;
  }
}
