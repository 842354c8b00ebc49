// fails: one frame of any length ends where the formula says
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The velocity of the bracket alone.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double y = x - target, rush = v + omega * y, left = std::exp(-omega * h);
  x = target + (y + rush * h) * left;
  v = rush * left;
}
