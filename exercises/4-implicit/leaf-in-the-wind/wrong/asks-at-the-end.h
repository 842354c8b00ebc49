// fails: at 30 frames a second, too
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// As backward Euler would: the mistake is as large, and on the other side.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  v = (v + c * h * wind(x + h * v, t + h)) / (1 + c * h);
  x += h * v;
}
