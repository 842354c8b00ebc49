// RUNTIME_ERROR: asks for eight terabytes
// says: bad_alloc
// SPDX-License-Identifier: MIT-0
#pragma once
#include <vector>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  std::vector<double> huge(1'000'000'000'000);
  x.x = huge[5];
}
