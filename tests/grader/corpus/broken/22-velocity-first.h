// PARTIAL: updates the velocity first
// says: symplectic Euler
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v = v + h * acceleration(x, v, t);
  x = x + h * v;
}
