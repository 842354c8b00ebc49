// Fails: each step takes the mean of both slopes
// Says: this is symplectic Euler
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps the energy within bounds, which is not the same.
inline void step(double& x, double& v, double h, double omega, double zeta) {
  v += h * (-omega * omega * x - 2 * zeta * omega * v);
  x += h * v;
}

inline double told(double omega, double h) {
  return 2 / h * std::tan(omega * h / 2);
}
