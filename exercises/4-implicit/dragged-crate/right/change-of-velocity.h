// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The acceleration at x + h v with the old velocity, over what a change of velocity meets.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const double k = omega * omega, c = 2 * zeta * omega;
  const Vec a = k * (hand - (x + h * v)) - c * v;
  v += h * a / (1 + h * c + h * h * k);
  x += h * v;
}
