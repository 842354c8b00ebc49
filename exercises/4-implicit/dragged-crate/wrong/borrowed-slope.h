// fails: without damping a step divides the energy by 1 + (h omega)^2
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Symplectic Euler, sold as implicit: only the position uses something new.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const Vec a = omega * omega * (hand - x) - 2 * zeta * omega * v;
  v += h * a;
  x += h * v;
}
