// fails: with Kutta's table of three rows half the step divides the error by eight
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Each stage overwrites what the slopes before the last one did: github.com/openrocket/openrocket,
// pull request 3013. RK4 never notices.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  std::vector<Vec> velocities, accelerations;
  for (const std::vector<double>& row : parts) {
    Vec x_stage = x, v_stage = v;
    double time = t;
    for (std::size_t j = 0; j < row.size(); ++j) {
      x_stage = x + h * row[j] * velocities[j];
      v_stage = v + h * row[j] * accelerations[j];
      time += h * row[j];
    }
    velocities.push_back(v_stage);
    accelerations.push_back(acceleration(x_stage, v_stage, time));
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    x += h * weights[i] * velocities[i];
    v += h * weights[i] * accelerations[i];
  }
}
