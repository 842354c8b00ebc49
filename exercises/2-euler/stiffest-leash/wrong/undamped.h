// fails: a leash that swings holds up to the longest step
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The limit of symplectic Euler.
inline double longest_step(double k, double c, double m) {
  return 2 / std::sqrt(k / m);
}
