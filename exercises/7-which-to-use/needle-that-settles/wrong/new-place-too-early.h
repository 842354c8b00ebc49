// fails: uneven frames that add up end where one frame does
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The second line uses the place that the first one has changed.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double left = std::exp(-omega * h);
  x = target + (x - target + (v + omega * (x - target)) * h) * left;
  v = (v - omega * (v + omega * (x - target)) * h) * left;
}
