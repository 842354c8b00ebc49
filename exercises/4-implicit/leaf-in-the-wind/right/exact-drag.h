// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// In a wind that stays as it is, the motion has a formula.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const Vec w = wind(x + h / 2 * v, t + h / 2);
  const Vec off = v - w;
  x += h * w - std::expm1(-c * h) / c * off;
  v = w + std::exp(-c * h) * off;
}
