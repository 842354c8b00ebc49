// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The new position first, and the velocity from how far the crate came.
inline double end(double x, double v, double h, double hand, double omega, double zeta) {
  const double pull = (h * omega) * (h * omega), brake = 1 + 2 * zeta * h * omega;
  return (brake * x + h * v + pull * hand) / (brake + pull);
}

inline void step(Vec& x, Vec& v, double h, const Vec& hand, double omega, double zeta) {
  const Vec next{end(x.x, v.x, h, hand.x, omega, zeta), end(x.y, v.y, h, hand.y, omega, zeta),
                 end(x.z, v.z, h, hand.z, omega, zeta)};
  v = (next - x) / h;
  x = next;
}
