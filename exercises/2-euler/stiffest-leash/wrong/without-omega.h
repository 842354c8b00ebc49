// Fails: a leash that swings holds up to the longest step
// Says: this is h omega, and h was asked
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// h omega where h was asked.
inline double longest_step(double k, double c, double m) {
  const double zeta = c / (2 * std::sqrt(k * m));
  if (zeta <= 1) return 2 * zeta;
  return 2 / (zeta + std::sqrt(zeta * zeta - 1));
}
