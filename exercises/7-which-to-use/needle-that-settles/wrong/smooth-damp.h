// Fails: one frame of any length ends at the place where tiny steps do
// Says: this is 1 / (1 + z + 0.48 z^2 + 0.235 z^3) in place of exp(-z): close, and not exact
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The exponential replaced by a fraction, from T. Lowe, Critically Damped Ease-In/Ease-Out
// Smoothing, Game Programming Gems 4 (2004); shipped in the smoothing functions of many engines.
inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  const double z = omega * h, there = target - 2 * u / omega, y = x - there, w = v - u;
  const double left = 1 / (1 + z + 0.48 * z * z + 0.235 * z * z * z);
  const double rush = (w + omega * y) * h;
  v = u + (w - omega * rush) * left;
  x = there + u * h + (y + rush) * left;
}
