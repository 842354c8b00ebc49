// fails: finding out costs no more than four runs
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Ends the search far beyond the answer, for the best of estimates.
inline Vec place(Vec x, Vec v, double duration, int steps, const Acceleration& acceleration) {
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    const Vec a = acceleration(x, v, n * h);
    x += h * v;
    v += h * a;
  }
  return x;
}

inline int steps_needed(const Vec& x, const Vec& v, double duration, double wanted,
                        const Acceleration& acceleration) {
  Vec coarse = place(x, v, duration, 16, acceleration);
  for (int steps = 32;; steps *= 2) {
    const Vec fine = place(x, v, duration, steps, acceleration);
    const double needed = steps * length(fine - coarse) / wanted;
    if (needed < steps / 4) return static_cast<int>(std::ceil(1.01 * needed));
    coarse = fine;
  }
}
