// fails: a thrown leaf stops where it should, and is never thrown back
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// Takes the wind's velocity for the leaf's, as particle effects do.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  v = wind(x + h / 2 * v, t + h / 2);
  x += h * v;
}
