// fails: uneven frames that add up end where one frame does
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void settle(double& x, double& v, double target, double omega, double h) {
  v += h * (omega * omega * (target - x) - 2 * omega * v);
  x += h * v;
}
