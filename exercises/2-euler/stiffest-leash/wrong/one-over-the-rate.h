// fails: a leash that creeps is limited by its fast motion
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Where the fast motion no longer turns round, which is half of where it explodes.
inline double longest_step(double k, double c, double m) {
  if (c * c <= 4 * k * m) return c / k;
  return 2 * m / (c + std::sqrt(c * c - 4 * k * m));
}
