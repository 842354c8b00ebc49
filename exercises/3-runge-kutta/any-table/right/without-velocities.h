// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Nystroem's way: the velocities of the stages are put into the sums for the place, so that only
// accelerations are kept.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  const std::size_t stages = parts.size();
  std::vector<Vec> a;
  const auto ahead = [&](const std::vector<double>& row, Vec& place, Vec& velocity) {
    double reach = 0;
    for (std::size_t j = 0; j < row.size(); ++j) {
      reach += row[j];
      velocity += h * (row[j] * a[j]);
      for (std::size_t k = 0; k < j; ++k) place += h * h * row[j] * parts[j][k] * a[k];
    }
    place += reach * h * v;
    return t + reach * h;
  };
  for (std::size_t i = 0; i < stages; ++i) {
    Vec place = x, velocity = v;
    const double time = ahead(parts[i], place, velocity);
    a.push_back(acceleration(place, velocity, time));
  }
  Vec x_end = x, v_end = v;
  ahead(weights, x_end, v_end);
  x = x_end;
  v = v_end;
}
