// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec velocity = v;
  v += acceleration(x, v, t) * h;
  x += velocity * h;
}

// With its own step: what a turn does is tried, and the interval halved.
inline double flown(int steps) {
  Vec x{1, 0, 0}, v{0, 1, 0};
  for (int n = 0; n < steps; ++n) {
    step(x, v, 0, 2 * std::numbers::pi / steps,
         [](const Vec& at, const Vec&, double) { return -at; });
  }
  return length(x);
}

inline int steps_per_turn(double growth) {
  int too_few = 0, enough = 16;
  while (flown(enough) > 1 + growth) enough *= 2;
  while (enough - too_few > 1) {
    const int steps = (too_few + enough) / 2;
    (flown(steps) > 1 + growth ? too_few : enough) = steps;
  }
  return enough;
}
