// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The product of the two rates is k/m.
inline double longest_step(double k, double c, double m) {
  if (c * c < 4 * k * m) return c / k;
  const double root = std::sqrt((c - 2 * std::sqrt(k * m)) * (c + 2 * std::sqrt(k * m)));
  const double fast = c + root, slow = 4 * k * m / fast;
  return slow / k;
}
