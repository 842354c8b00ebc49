// fails: a table that nobody has published is followed to rounding
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The stages pile up: each starts where the one before it was.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  std::vector<Vec> velocities, accelerations;
  Vec x_stage = x, v_stage = v;
  for (const std::vector<double>& row : parts) {
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
