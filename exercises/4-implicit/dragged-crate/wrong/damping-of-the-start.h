// fails: the slope at the end leads back to the start
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The pull is taken at the end, the damping at the start.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const double angle = h * omega;
  v = (v + angle * omega * (hand - x) - 2 * zeta * angle * v) / (1 + angle * angle);
  x += h * v;
}
