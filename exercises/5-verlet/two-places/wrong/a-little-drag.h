// fails: five steps under a hidden force are those of position Verlet
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The 0.99 of a tutorial's cloth, kept.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x + 0.99 * (x - x_previous) + h * h * a;
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x - h * v + h * h / 2 * a;
}
