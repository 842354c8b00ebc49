// fails: a leash that creeps is limited by its fast motion
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Two over the slow rate: what one sees.
inline double longest_step(double k, double c, double m) {
  if (c * c <= 4 * k * m) return c / k;
  return 4 * m / (c - std::sqrt(c * c - 4 * k * m));
}
