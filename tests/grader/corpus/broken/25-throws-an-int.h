// RUNTIME_ERROR: throws a number
// never: overflow
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  throw 42;
}
