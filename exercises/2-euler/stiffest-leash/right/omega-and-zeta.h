// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double longest_step(double k, double c, double m) {
  const double omega = std::sqrt(k / m), zeta = c / (2 * std::sqrt(k * m));
  if (zeta <= 1) return 2 * zeta / omega;
  // The difference of the chapter, times its sum over its sum.
  return 2 / (zeta + std::sqrt(zeta * zeta - 1)) / omega;
}
