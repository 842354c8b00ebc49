// fails: two stars that turn around each other stay where they are together
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Each pair once, and only one of it kicked.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) v[i] += h * pull(x[j] - x[i], mu[j]);
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
