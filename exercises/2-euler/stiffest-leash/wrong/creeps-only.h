// fails: a leash that swings holds up to the longest step
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Two over the rate, as if nothing swung.
inline double longest_step(double k, double c, double m) {
  const double half = c / (2 * m);
  return 2 / (half + std::sqrt(std::max(0.0, half * half - k / m)));
}
