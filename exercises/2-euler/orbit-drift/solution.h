// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of Euler's method.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}

/// The fewest equal steps of Euler's method that take the drone once around its circle and not too
/// far out.
inline int steps_per_turn(double growth) {
  for (int steps = 1;; ++steps) {
    const double angle = 2 * std::numbers::pi / steps;
    if (std::pow(1 + angle * angle, steps / 2.0) <= 1 + growth) return steps;
  }
}
