// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

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
  // The error is C/n + D/n^2. From three runs both are known.
  const Vec one = place(x, v, duration, 64, acceleration);
  const Vec two = place(x, v, duration, 128, acceleration);
  const Vec four = place(x, v, duration, 256, acceleration);
  const Vec first = 2 * two - one, second = 2 * four - two;
  const Vec truth = (4 * second - first) / 3;
  int needed = 256;
  needed = static_cast<int>(std::ceil(needed * length(four - truth) / wanted));
  return needed + needed / 25;
}
