// Fails: it lands eighty times nearer than RK4 in equal steps
// Says: more than half of the evaluations were never spent
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Asks at three places for the planet's pull, its flatness and the tug along z, and needs no more
// evaluations for 60 000 steps.
inline void rk4(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a1 = acceleration(x, v, t);
  const Vec v2 = v + h / 2 * a1, a2 = acceleration(x + h / 2 * v, v2, t + h / 2);
  const Vec v3 = v + h / 2 * a2, a3 = acceleration(x + h / 2 * v2, v3, t + h / 2);
  const Vec v4 = v + h * a3, a4 = acceleration(x + h * v3, v4, t + h);
  x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
  v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  const Vec one = acceleration({1, 0, 0}, {}, 0), two = acceleration({2, 0, 0}, {}, 0);
  // mu (1 + f) = -one.x, and mu (1 + f / 4) / 4 = -two.x
  const double f_mu = 4.0 / 3 * (4 * two.x - one.x), mu = -one.x - f_mu;
  const double tug = acceleration({1, 0, 0}, {}, 0).z;
  const Acceleration copy = [=](const Vec& at, const Vec&, double now) {
    const double r2 = dot(at, at), r = std::sqrt(r2);
    return (-(mu + f_mu / r2) / (r2 * r)) * at + Vec{0, 0, tug * std::cos(now)};
  };
  const double h = seconds / 60000;
  for (int n = 0; n < 60000; ++n) rk4(x, v, t + n * h, h, copy);
}
