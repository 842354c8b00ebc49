// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

// A divisor with one more term of the exponential; the way follows from what the velocity lost.
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const double ch = c * h;
  Vec place = x;
  place += h / 2 * v;
  const Vec w = wind(place, t + h / 2);
  const Vec next = w + (v - w) / (1 + ch + ch * ch / 2);
  x += h * w + ((v - w) - (next - w)) / c;
  v = next;
}
