// Fails: the shuttle lands twenty times nearer than RK4 in equal steps
// Says: the last question is for 0.0191 s after the end: does the flight end at its very second?
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Flies until the time is up, and a step further.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const double end = t + seconds;
  while (t < end) {
    const double h = 0.12 * std::pow(length(x), 1.5);
    rk4(x, v, t, h, acceleration);
    t += h;
  }
}
