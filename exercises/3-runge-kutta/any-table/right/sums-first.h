// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The sum of a row times what the slopes hold, for places, velocities and weights alike.
inline Vec sum(const std::vector<double>& row, const std::vector<Vec>& slopes) {
  Vec total;
  for (std::size_t j = 0; j < row.size(); ++j) total = total + row[j] * slopes[j];
  return total;
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  const std::size_t stages = weights.size();
  std::vector<Vec> dx(stages), dv(stages);
  for (std::size_t i = 0; i < stages; ++i) {
    double reach = 0;
    for (const double part : parts[i]) reach += part;
    const Vec place = x + h * sum(parts[i], dx);
    dx[i] = v + h * sum(parts[i], dv);
    dv[i] = acceleration(place, dx[i], t + reach * h);
  }
  x = x + h * sum(weights, dx);
  v = v + h * sum(weights, dv);
}
