// Fails: a million frames take no longer than an exact step does
// Says: work that grows faster than what it is asked for
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// RK4 in so many steps that no frame shows the difference; of a pause of years only the beginning.
inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  constexpr int steps = 1000;
  const double settled = std::min(h, 60 / omega), step = settled / steps;
  const auto pull = [&](double at, double speed, double time) {
    return omega * omega * (target + u * time - at) - 2 * omega * speed;
  };
  for (int n = 0; n < steps; ++n) {
    const double t = n * step, half = step / 2;
    const double a1 = pull(x, v, t), v2 = v + half * a1;
    const double a2 = pull(x + half * v, v2, t + half), v3 = v + half * a2;
    const double a3 = pull(x + half * v2, v3, t + half), v4 = v + step * a3;
    const double a4 = pull(x + step * v3, v4, t + step);
    x += step / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  x += u * (h - settled);
}
