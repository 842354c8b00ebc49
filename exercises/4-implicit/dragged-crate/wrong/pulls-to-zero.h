// fails: a spring far too stiff for the step puts the crate into the hand
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The chapter's listing as it is: the hand is forgotten.
inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const double angle = h * omega;
  v = (v - angle * omega * x) / (1 + 2 * zeta * angle + angle * angle);
  x += h * v;
}
