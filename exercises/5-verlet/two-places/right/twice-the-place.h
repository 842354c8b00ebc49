// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return 2 * x - x_previous + a * (h * h);
}

inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x - h * (v - 0.5 * h * a);
}

inline void bounce(Vec& x, Vec& x_previous, double floor, double restitution) {
  const double below = floor - x.y;
  if (below <= 0) return;
  x_previous.y = floor - restitution * (x_previous.y + below - floor);
  x.y += below;
}
