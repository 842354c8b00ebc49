// MEMORY_LIMIT: takes all memory and touches it, with new
// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  std::vector<double> all;
  for (;;) all.push_back(1);
}
