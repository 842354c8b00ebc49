// Fails: without a damper the energy stays for a minute
// Says: this is backward Euler
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The h^2 of backward Euler, all of it; and its position.
inline void step(double& x, double& v, double h, double omega, double zeta) {
  v = (v - h * omega * omega * x) / (1 + 2 * zeta * h * omega + h * h * omega * omega);
  x += h * v;
}

inline double told(double omega, double h) {
  return 2 / h * std::tan(omega * h / 2);
}
