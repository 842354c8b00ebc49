// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of position Verlet, with drag at the velocity of now.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  const double half = c * h / 2;
  return x + ((1 - half) * (x - x_previous) + h * h * a) / (1 + half);
}
