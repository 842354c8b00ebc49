// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The needle one frame later, exactly.
inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  const double behind = 2 * u / omega;
  const double y = x - target + behind, w = v - u;
  const double rush = w + omega * y, left = std::exp(-omega * h);
  x = target + u * h - behind + (y + rush * h) * left;
  v = u + (w - omega * rush * h) * left;
}
