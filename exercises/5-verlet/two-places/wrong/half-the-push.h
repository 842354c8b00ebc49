// fails: the next place is as far again and a push further
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The half of Taylor's formula. The step has none: it is the sum of two such formulas.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x + (x - x_previous) + h * h / 2 * a;
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x - h * v + h * h / 2 * a;
}
