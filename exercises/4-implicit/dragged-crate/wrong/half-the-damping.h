// fails: the slope at the end leads back to the start
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The 2 of 2 zeta omega is lost.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const double angle = h * omega;
  v = (v + angle * omega * (hand - x)) / (1 + zeta * angle + angle * angle);
  x += h * v;
}
