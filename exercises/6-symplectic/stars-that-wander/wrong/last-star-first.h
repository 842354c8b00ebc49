// fails: two stars that turn around each other stay where they are together
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The same mistake from the other end of the list.
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = x.size(); i-- > 0;) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) v[i] += h * pull(x[j] - x[i], mu[j]);
    }
    x[i] += h * v[i];
  }
}
