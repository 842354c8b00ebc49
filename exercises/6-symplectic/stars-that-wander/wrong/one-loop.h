// fails: the order of the stars in the list makes no difference
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As the starter: a star is moved before the next one is pulled. Shipped, for example, in
// ybrodsky/gravity until its pull request 1 (2016), "you cannot resolve forces in the same loop".
inline Vec pull(const Vec& to, double mu) {
  const double r = length(to);
  return (mu / (r * r * r)) * to;
}

inline void step(std::vector<Vec>& x, std::vector<Vec>& v, const std::vector<double>& mu,
                 double h) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) v[i] += h * pull(x[j] - x[i], mu[j]);
    }
    x[i] += h * v[i];
  }
}
