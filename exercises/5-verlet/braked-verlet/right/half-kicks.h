// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The velocity of the last middle, braked at its beginning, kicked, and braked at its end.
inline Vec braked(const Vec& v, double brake) {
  return v - brake * v;
}
inline Vec divided(const Vec& v, double brake) {
  return v / (1 + brake);
}

inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  const double brake = 0.5 * c * h;
  Vec v = (x - x_previous) / h;
  v = braked(v, brake);
  v += h * a;
  v = divided(v, brake);
  return x + h * v;
}
