// OUTPUT_LIMIT: prints without end
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdio>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) std::puts("again and again");
}
