// Fails: a table that nobody has published is followed to rounding
// Says: this is RK4
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// RK4, whatever the table says.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  const Vec a1 = acceleration(x, v, t), v2 = v + (h / 2) * a1;
  const Vec a2 = acceleration(x + (h / 2) * v, v2, t + h / 2), v3 = v + (h / 2) * a2;
  const Vec a3 = acceleration(x + (h / 2) * v2, v3, t + h / 2), v4 = v + h * a3;
  const Vec a4 = acceleration(x + h * v3, v4, t + h);
  x += (h / 6) * (v + 2 * v2 + 2 * v3 + v4);
  v += (h / 6) * (a1 + 2 * a2 + 2 * a3 + a4);
}
