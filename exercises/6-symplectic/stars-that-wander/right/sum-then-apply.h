// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// All accelerations first; then each star on its own.
inline Vec felt(const std::vector<Vec>& x, const std::vector<double>& mu, std::size_t star) {
  Vec sum;
  for (std::size_t other = 0; other < x.size(); ++other) {
    if (other == star) continue;
    const Vec to = x[other] - x[star];
    sum += mu[other] * to / std::pow(dot(to, to), 1.5);
  }
  return sum;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  std::vector<Vec> a;
  for (std::size_t i = 0; i < x.size(); ++i) a.push_back(felt(x, mu, i));
  for (std::size_t i = 0; i < x.size(); ++i) {
    v[i] += h * a[i];
    x[i] += h * v[i];
  }
}
