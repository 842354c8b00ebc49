// Fails: at 30 frames a second one question a frame keeps the leaves near their paths, too
// Says: it asks 10 times in each frame
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// Substeps small enough for an explicit method, at ten times the price.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  for (int n = 0; n < 10; ++n) {
    v += c * h / 10 * (wind(x, t + n * h / 10) - v);
    x += h / 10 * v;
  }
}
