// fails: at 60 frames a second one question a frame keeps the leaves near their paths
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// The right place, and the drag of the start: above c h = 2 the leaf explodes.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const Vec w = wind(x + h / 2 * v, t + h / 2);
  v += c * h * (w - v);
  x += h * v;
}
