// fails: one step takes the drag at the velocity of now
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The division belongs to what is added, not to the place.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return (x + (1 - c * h / 2) * (x - x_previous) + h * h * a) / (1 + c * h / 2);
}
