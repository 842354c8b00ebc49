// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of backward Euler on a damped spring that pulls to a hand.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const double angle = h * omega;
  v = (v + angle * omega * (hand - x)) / (1 + 2 * zeta * angle + angle * angle);
  x = x + h * v;
}
