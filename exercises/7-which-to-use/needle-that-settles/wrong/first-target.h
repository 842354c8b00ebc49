// fails: a target that jumps is followed, and the speed is kept
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Remembers the target of its first frame.
inline void settle(double& x, double& v, double target, double omega, double h) {
  static const double goal = target;
  const double y = x - goal, rush = v + omega * y, left = std::exp(-omega * h);
  x = goal + (y + rush * h) * left;
  v = (v - omega * rush * h) * left;
}
