// Fails: a leash like a wall keeps its digits
// Says: the first digits are right: a difference of nearly equal numbers lost the others
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Right on paper: a difference of two large numbers that are nearly equal.
inline double longest_step(double k, double c, double m) {
  const double omega = std::sqrt(k / m), zeta = c / (2 * std::sqrt(k * m));
  if (zeta <= 1) return 2 * zeta / omega;
  return 2 * (zeta - std::sqrt(zeta * zeta - 1)) / omega;
}
