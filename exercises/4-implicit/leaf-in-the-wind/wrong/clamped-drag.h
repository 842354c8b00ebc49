// fails: a thrown leaf stops where it should, and is never thrown back
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// The explicit step with its factor cut off at 1, so that it cannot explode.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const Vec w = wind(x + h / 2 * v, t + h / 2);
  v += std::min(c * h, 1.0) * (w - v);
  x += h * v;
}
