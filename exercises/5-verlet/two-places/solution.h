// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Where a spark is one step later, by position Verlet.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x + (x - x_previous) + h * h * a;
}

/// Where a spark that starts now would have been one step ago.
inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x - h * v + h * h / 2 * a;
}

/// Lets a spark that is below the floor bounce off it; one that is not is left alone.
inline void bounce(Vec& x, Vec& x_previous, double floor, double restitution) {
  if (x.y >= floor) return;
  const double fallen = x.y - x_previous.y;
  x.y = floor;
  x_previous.y = floor + restitution * fallen;
}
