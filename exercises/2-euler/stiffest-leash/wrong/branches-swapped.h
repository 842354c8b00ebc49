// Fails: a leash that swings holds up to the longest step
// Says: this is two over a rate, as for a leash that creeps, and this one swings
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double longest_step(double k, double c, double m) {
  const double omega = std::sqrt(k / m), zeta = c / (2 * std::sqrt(k * m));
  if (zeta >= 1) return 2 * zeta / omega;
  return 2 / (zeta + std::sqrt(std::abs(zeta * zeta - 1))) / omega;
}
