// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A far better method finds the truth for the price of a few steps.
inline Vec truth(Vec x, Vec v, double duration, const Acceleration& acceleration) {
  constexpr int steps = 40;
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const Vec a1 = acceleration(x, v, t), v2 = v + h / 2 * a1;
    const Vec a2 = acceleration(x + h / 2 * v, v2, t + h / 2), v3 = v + h / 2 * a2;
    const Vec a3 = acceleration(x + h / 2 * v2, v3, t + h / 2), v4 = v + h * a3;
    const Vec a4 = acceleration(x + h * v3, v4, t + h);
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return x;
}

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
  constexpr int tried = 200;
  const Vec there = place(x, v, duration, tried, acceleration);
  const double error = length(there - truth(x, v, duration, acceleration));
  return static_cast<int>(1.02 * tried * error / wanted) + 1;
}
