// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The needle one frame later, exactly.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double y = x - target, rush = v + omega * y, left = std::exp(-omega * h);
  x = target + (y + rush * h) * left;
  v = (v - omega * rush * h) * left;
}
