// fails: a target that jumps is followed, and the speed is kept
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The spring of the formula, which rests at zero.
inline void settle(double& x, double& v, double target, double omega, double h) {
  const double rush = v + omega * x, left = std::exp(-omega * h);
  x = (x + rush * h) * left;
  v = (v - omega * rush * h) * left;
}
