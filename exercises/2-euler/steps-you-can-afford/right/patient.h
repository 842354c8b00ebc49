// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Where Euler's method ends.
inline Vec place(Vec x, Vec v, double duration, int steps, const Acceleration& acceleration) {
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    const Vec a = acceleration(x, v, n * h);
    x += h * v;
    v += h * a;
  }
  return x;
}

// Looks further than it must, and leaves more than it must: half of what is allowed and more.
/// The number of equal steps of Euler's method that end within the wanted error.
/// @param x  position at time 0 [m]
/// @param v  velocity at time 0 [m/s]
/// @param duration  of the run [s]
/// @param wanted  error of the position at the end [m]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]; each call counts
inline int steps_needed(const Vec& x, const Vec& v, double duration, double wanted,
                        const Acceleration& acceleration) {
  constexpr double margin = 1.06;
  Vec coarse = place(x, v, duration, 16, acceleration);
  for (int steps = 32;; steps *= 2) {
    const Vec fine = place(x, v, duration, steps, acceleration);
    // Half the steps have twice the error, so the two runs differ by the error of the finer one.
    const double needed = steps * length(fine - coarse) / wanted;
    if (needed < steps) return static_cast<int>(std::ceil(margin * needed));
    coarse = fine;
  }
}
