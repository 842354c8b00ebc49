// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Each pair once, and both of it kicked.
inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      const Vec to = x[j] - x[i];
      const double r = length(to);
      const Vec kick = (h / (r * r * r)) * to;
      v[i] += mu[j] * kick;
      v[j] -= mu[i] * kick;
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
