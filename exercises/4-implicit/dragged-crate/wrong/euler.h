// fails: a spring far too stiff for the step puts the crate into the hand
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const Vec a = omega * omega * (hand - x) - 2 * zeta * omega * v;
  x += h * v;
  v += h * a;
}
