// fails: without damping a step divides the energy by 1 + (h omega)^2
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  v = (v + h * omega * omega * (hand - x)) / (1 + 2 * zeta * h * omega + h * omega * omega);
  x += h * v;
}
