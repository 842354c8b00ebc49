// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

inline Vec half_way(const Vec& from, const Vec& rate, double h) {
  return from + 0.5 * h * rate;
}

inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  const Vec air = wind(half_way(x, v, h), t + 0.5 * h);
  const Vec change = c * h / (1 + c * h) * (air - v);
  v += change;
  x += v * h;
}
