// Fails: the acceleration is asked for once a step, at its start
// Says: ten small steps stand for one: nearer, and at ten times the price
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Ten small steps for one: closer, and ten times the price.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (int n = 0; n < 10; ++n) {
    const Vec a = acceleration(x, v, t + n * h / 10);
    x += h / 10 * v;
    v += h / 10 * a;
  }
}

inline int steps_per_turn(double growth) {
  int steps = 1;
  while (std::pow(1 + std::pow(2 * std::numbers::pi / steps, 2), steps / 2.0) > 1 + growth) ++steps;
  return steps;
}
