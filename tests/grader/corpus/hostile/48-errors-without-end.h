// OUTPUT_LIMIT: prints errors without end
// SPDX-License-Identifier: MIT-0
#pragma once
#include <iostream>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) std::cerr << "again and again\n";
}
