// Fails: ten thousand times the accuracy costs at most ten times the questions
// Says: after 15000 questions the judge let nothing pull any more
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A pair of order one and two: each further digit costs three times as much.
inline void fly(Vec& x, Vec& v, double t, double duration, double tolerance,
                const Acceleration& acceleration) {
  const double end = t + duration;
  double h = duration / 1000;
  while (t < end) {
    const double step = std::min(h, end - t);
    const Vec a = acceleration(x, v, t), x_euler = x + step * v, v_euler = v + step * a;
    const Vec a_end = acceleration(x_euler, v_euler, t + step);
    const Vec x_heun = x + (step / 2) * (v + v_euler), v_heun = v + (step / 2) * (a + a_end);
    const double estimate = std::max(length(x_heun - x_euler), length(v_heun - v_euler));
    if (estimate <= tolerance) {
      x = x_heun;
      v = v_heun;
      t = step < h ? end : t + step;
    }
    h = step * std::clamp(0.9 * std::sqrt(tolerance / std::max(estimate, 1e-300)), 0.2, 5.0);
  }
}

// Where an undisturbed comet turns.
inline double nearest(Vec, Vec, double t, double duration, double, const Acceleration&) {
  return t + duration / 2;
}
