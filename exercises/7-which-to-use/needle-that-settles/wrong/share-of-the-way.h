// fails: one frame of any length ends where the formula says
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The smoothing of the second chapter: no velocity at all.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double before = x;
  x += (1 - std::exp(-omega * h)) * (target - x);
  v = (x - before) / h;
}
