// Fails: the shuttle lands eighty times nearer than RK4 in equal steps
// Says: more than half of the evaluations were never spent
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Asks once, takes the planet for a point, and needs no more evaluations for 20000 steps.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const double mu = length(acceleration(x, v, t)) * dot(x, x);
  const auto pull = [=](const Vec& at, const Vec&, double) {
    return -mu / std::pow(length(at), 3) * at;
  };
  const double h = seconds / 20000;
  for (int n = 0; n < 20000; ++n) rk4(x, v, 0, h, pull);
}
