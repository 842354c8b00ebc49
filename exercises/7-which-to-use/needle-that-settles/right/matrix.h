// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  const double z = omega * h, e = 1 / std::exp(z), trail = u * (2 / omega);
  const double xx = (1 + z) * e, xv = h * e, vx = -omega * z * e, vv = (1 - z) * e;
  const double y = x - (target - trail), w = v - u;
  x = xx * y + xv * w + (target - trail + h * u);
  v = vx * y + vv * w + u;
}
