// MEMORY_LIMIT: takes all memory and touches a part of it
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdlib>
#include <cstring>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) std::memset(std::malloc(1 << 24), 1, 1 << 20);
}
