// fails: one step takes the drag at the velocity of now
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// One per cent a step, whatever c is.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return x + 0.99 * (x - x_previous) + h * h * a;
}
