// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// On a spring the slope half-way is the mean of both ends' slopes.
inline void step(double& x, double& v, double h, double omega, double zeta) {
  const double half = h / 2;
  const double middle =
      (v - half * omega * omega * x) / (1 + h * zeta * omega + half * half * omega * omega);
  x += h * middle;
  v = 2 * middle - v;
}

inline double told(double omega, double h) {
  return 2 / h * std::tan(omega * h / 2);
}
