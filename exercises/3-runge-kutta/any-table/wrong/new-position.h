// fails: with Kutta's table of three rows half the step divides the error by eight
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The velocity of the end is used for the position, as in symplectic Euler.
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
  for (std::size_t i = 0; i < weights.size(); ++i) v += h * weights[i] * accelerations[i];
  x += h * v;
}
