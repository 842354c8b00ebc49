// fails: uneven frames that add up end where one frame does
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The velocity that the frame had in the mean.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double before = x, y = x - target;
  x = target + (y + (v + omega * y) * h) * std::exp(-omega * h);
  v = (x - before) / h;
}
