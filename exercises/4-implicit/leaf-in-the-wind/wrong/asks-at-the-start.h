// fails: at 60 frames a second one question a frame keeps the leaves near their paths
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  v = (v + c * h * wind(x, t)) / (1 + c * h);
  x += h * v;
}
