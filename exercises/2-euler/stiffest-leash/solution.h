// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The longest step with which Euler's method holds a leash [s]; 0 if there is none.
/// @param k  stiffness [N/m], above 0
/// @param c  damper [N s/m], 0 or more
/// @param m  mass [kg], above 0
inline double longest_step(double k, double c, double m) {
  const double beyond_critical = c * c - 4 * k * m;
  if (beyond_critical <= 0) return c / k;
  const double fast_rate = (c + std::sqrt(beyond_critical)) / (2 * m);
  return 2 / fast_rate;
}
