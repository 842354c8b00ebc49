// fails: no more than a tenth of the steps could be spared
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The two runs differ by the error of the finer, not of the coarser one: twice the steps.
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
    if (needed < 3 * steps) return static_cast<int>(std::ceil(1.03 * 2 * needed));
    coarse = fine;
  }
}
