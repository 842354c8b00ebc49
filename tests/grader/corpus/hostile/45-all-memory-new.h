// MEMORY_LIMIT|TIME_LIMIT: takes all memory and touches it, with new; which of the limits it meets first is up to the system
// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  std::vector<double> all;
  for (;;) all.push_back(1);
}
