// Fails: short chains end where the slope of the end leads back to the start
// Says: in the matrix all springs are like the first
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The matrix of the chapter, in which all springs are alike.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  const std::size_t n = x.size();
  const double kappa = h * h * k[0];
  std::vector<double> middle(n), right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double pull = k[i] * (i > 0 ? x[i] - x[i - 1] : x[i]);
    right[i] += v[i] - h * pull;
    if (i > 0) right[i - 1] += h * pull;
    middle[i] = 1 + (i + 1 < n ? 2 : 1) * kappa;
  }
  for (std::size_t i = 1; i < n; ++i) {
    const double multiple = -kappa / middle[i - 1];
    middle[i] += multiple * kappa;
    right[i] -= multiple * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    v[i] = (right[i] + (i + 1 < n ? kappa * v[i + 1] : 0)) / middle[i];
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
