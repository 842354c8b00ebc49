// Fails: a leash that swings holds up to the longest step
// Says: this is right for twice the damper: what is zeta?
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double longest_step(double k, double c, double m) {
  const double omega = std::sqrt(k / m), zeta = c / std::sqrt(k * m);
  if (zeta <= 1) return 2 * zeta / omega;
  return 2 / (zeta + std::sqrt(zeta * zeta - 1)) / omega;
}
