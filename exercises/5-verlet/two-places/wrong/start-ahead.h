// fails: the place before the start is the one of Taylor's formula
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x + (x - x_previous) + h * h * a;
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x + h * v + h * h / 2 * a;
}
