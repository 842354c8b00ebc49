// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps all slopes, and finds each stage by a row of a table.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  constexpr double row[4][3] = {{}, {1.0 / 3}, {-1.0 / 3, 1}, {1, -1, 1}}, weight[4] = {1, 3, 3, 1};
  Vec kx[4], kv[4], dx, dv;
  for (int i = 0; i < 4; ++i) {
    Vec place = x, velocity = v;
    for (int j = 0; j < i; ++j) {
      place += h * row[i][j] * kx[j];
      velocity += h * row[i][j] * kv[j];
    }
    kx[i] = velocity;
    kv[i] = acceleration(place, velocity, t + i * h / 3);
    dx += weight[i] * kx[i];
    dv += weight[i] * kv[i];
  }
  x += h * dx / 8;
  v += h * dv / 8;
}
