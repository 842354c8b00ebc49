// Fails: the thing ends within the wanted error, in less than three times the fewest steps
// Says: the finest of your runs, in 4 steps, is too coarse to tell how the error goes on
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Two short runs, where the error is not yet in proportion to the step.
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
  const Vec coarse = place(x, v, duration, 2, acceleration);
  const Vec fine = place(x, v, duration, 4, acceleration);
  return static_cast<int>(std::ceil(4 * length(fine - coarse) / wanted));
}
