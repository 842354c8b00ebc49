// Fails: five steps under a hidden force are Euler's
// Says: the velocity is kept in the program, and not where it is handed over: a second run begins with that of the first
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps the velocity between calls, and so breaks in the second run of a level.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  static Vec velocity = v;
  const Vec a = acceleration(x, velocity, t);
  x += h * velocity;
  velocity += h * a;
  v = velocity;
}

inline int steps_per_turn(double growth) {
  int steps = 1;
  while (std::pow(1 + std::pow(2 * std::numbers::pi / steps, 2), steps / 2.0) > 1 + growth) ++steps;
  return steps;
}
