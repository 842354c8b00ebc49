// fails: one step takes the drag at the velocity of now
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// 1/2 is 0 in whole numbers.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return x + ((1 - 1 / 2 * c * h) * (x - x_previous) + h * h * a) / (1 + 1 / 2 * c * h);
}
