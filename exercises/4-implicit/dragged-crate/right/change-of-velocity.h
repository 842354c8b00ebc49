// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The acceleration at x + h v with the old velocity, over what a change of velocity meets; and a
// share of it.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta,
                 double strongest) {
  const double k = omega * omega, c = 2 * zeta * omega;
  const Vec a = (1 / (1 + h * c + h * h * k)) * (k * (hand - (x + h * v)) - c * v);
  const double most = std::max(strongest, 1e-300);
  v += h / std::max(1.0, length(a) / most) * a;
  x += h * v;
}
