// Fails: a step keeps the sum of the areas
// Says: this is Euler's method: the stars moved with their old velocities
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Two loops, in the order of Euler's method.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  std::vector<Vec> a(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) a[i] += pull(x[j] - x[i], mu[j]);
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += h * v[i];
    v[i] += h * a[i];
  }
}
