// RUNTIME_ERROR|MEMORY_LIMIT: needs more memory before it starts than it may have
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline char large[1'200'000'000];

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  large[0] = 1;
}
