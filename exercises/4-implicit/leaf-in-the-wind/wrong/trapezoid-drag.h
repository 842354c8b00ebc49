// fails: a thrown leaf stops where it should, and is never thrown back
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// Closer to the path than is asked for; but a thrown leaf is thrown back, and forth.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const Vec w = wind(x + h / 2 * v, t + h / 2);
  const Vec next = (v + c * h * (w - 0.5 * v)) / (1 + c * h / 2);
  x += h / 2 * (v + next);
  v = next;
}
