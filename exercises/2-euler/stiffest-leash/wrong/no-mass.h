// Fails: a leash that swings holds up to the longest step
// Says: this is right for a mass of 1 kg
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// omega without its mass.
inline double longest_step(double k, double c, double m) {
  const double omega = std::sqrt(k), zeta = c / (2 * omega);
  if (zeta <= 1) return 2 * zeta / omega;
  return 2 / (zeta + std::sqrt(zeta * zeta - 1)) / omega;
}
