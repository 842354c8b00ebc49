// Fails: finding out steps that will do costs no more than four runs
// Says: the run that checks the others is ten times as fine as the replay needs, and costs more than the replay itself
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Finds the truth with the method itself, in ten times the steps.
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
    if (needed < 3 * steps) {
      const int guess = static_cast<int>(needed);
      const Vec truth = place(x, v, duration, 10 * guess, acceleration);
      const double error = length(place(x, v, duration, guess, acceleration) - truth) * 10 / 9;
      return static_cast<int>(std::ceil(1.02 * guess * error / wanted));
    }
    coarse = fine;
  }
}
