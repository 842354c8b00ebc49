// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void settle(double& x, double& v, double target, double omega, double h) {
  const double z = omega * h, e = 1 / std::exp(z), y = x - target;
  const double xx = (1 + z) * e, xv = h * e, vx = -omega * z * e, vv = (1 - z) * e;
  x = target + xx * y + xv * v;
  v = vx * y + vv * v;
}
