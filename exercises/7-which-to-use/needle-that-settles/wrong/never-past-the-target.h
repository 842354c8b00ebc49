// fails: one frame of any length ends where the formula says
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Held at the target as soon as it would go past it: a needle that starts fast has to.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double y = x - target, rush = v + omega * y, left = std::exp(-omega * h);
  const double next = (y + rush * h) * left;
  const bool past = next * y < 0;
  x = past ? target : target + next;
  v = past ? 0 : (v - omega * rush * h) * left;
}
