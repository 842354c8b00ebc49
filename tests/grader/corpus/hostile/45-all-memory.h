// MEMORY_LIMIT|TIME_LIMIT: takes and touches all memory; which of the limits it meets first is up to the system
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdlib>
#include <cstring>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) std::memset(std::malloc(1 << 24), 1, 1 << 24);
}
