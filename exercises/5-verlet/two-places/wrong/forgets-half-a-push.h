// fails: a spark that only falls passes through its true places
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Right in the first two terms, and so of order one: it goes through the places of symplectic
// Euler.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x + (x - x_previous) + h * h * a;
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x - h * v;
}
