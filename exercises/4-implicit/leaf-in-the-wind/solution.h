// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

/// One frame of a leaf.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const Vec w = wind(x + h / 2 * v, t + h / 2);
  v = (v + c * h * w) / (1 + c * h);
  x = x + h * v;
}
