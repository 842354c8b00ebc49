// fails: the acceleration is asked for once a step, at its start
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  x += h * v;
  v += h * acceleration(x, v, t);
}
