// Fails: a comet costs a fifth of what equal steps cost for the same error
// Says: no tenth of the flight has twice the questions of another: all steps are as long
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Sixty steps a second, whatever the tolerance: the comet is thrown out.
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
  const int steps = static_cast<int>(std::ceil(60 * duration));
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) rk4(x, v, t + n * h, h, acceleration);
}

// Where an undisturbed comet turns.
inline double nearest(Vec, Vec, double t, double duration, double, const Acceleration&) {
  return t + duration / 2;
}
