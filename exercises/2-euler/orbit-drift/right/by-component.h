// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double forward(double value, double rate, double h) {
  return value + rate * h;
}

inline Vec forward(const Vec& value, const Vec& rate, double h) {
  return {forward(value.x, rate.x, h), forward(value.y, rate.y, h), forward(value.z, rate.z, h)};
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const auto a = acceleration(x, v, t);
  const Vec next = forward(x, v, h);
  v = forward(v, a, h);
  x = next;
}

// n/2 log(1 + (2 pi/n)^2) = log(1 + growth), multiplied by n and solved for the n alone until that
// stands still. It is no whole number yet.
inline int steps_per_turn(double growth) {
  double steps = 2 * std::numbers::pi * std::numbers::pi / growth;
  for (int n = 0; n < 100; ++n) {
    const double angle = 2 * std::numbers::pi / steps;
    steps = steps * steps * std::log1p(angle * angle) / (2 * std::log1p(growth));
  }
  return static_cast<int>(std::ceil(steps));
}
