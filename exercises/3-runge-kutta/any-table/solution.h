// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of the Runge-Kutta method that a table describes.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  std::vector<Vec> velocities, accelerations;
  for (const std::vector<double>& row : parts) {
    Vec x_stage = x, v_stage = v;
    double time = t;
    for (std::size_t j = 0; j < row.size(); ++j) {
      x_stage += h * row[j] * velocities[j];
      v_stage += h * row[j] * accelerations[j];
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
