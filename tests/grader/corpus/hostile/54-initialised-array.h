// COMPILE_LIMIT: fills four gigabytes with one number
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline int large[1 << 30] = {1};

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x.x = large[1];
}
