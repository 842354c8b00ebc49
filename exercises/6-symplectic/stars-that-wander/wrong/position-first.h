// fails: a few steps of hidden stars are those of symplectic Euler
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The twin: keeps all that should be kept, and is another method.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) v[i] += h * pull(x[j] - x[i], mu[j]);
    }
  }
}
