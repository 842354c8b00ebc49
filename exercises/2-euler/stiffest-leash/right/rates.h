// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double longest_step(double k, double c, double m) {
  const double half = c / m / 2, square = half * half - k / m;
  return square < 0 ? c / k : 2 / (half + std::sqrt(square));
}
