// Fails: a single bead is a spring
// Says: the last bead's row has a spring beyond it, too, and there is none
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The last bead's row is like all others, as if a spring held it from beyond, too.
inline double at(const std::vector<double>& all, std::size_t i) {
  return i < all.size() ? all[i] : 0;
}

inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  const std::size_t n = x.size();
  std::vector<double> middle(n), right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double left = k[i], next = i + 1 < n ? k[i + 1] : k[i];
    middle[i] = 1 + h * h * (left + next);
    right[i] = v[i] + h * (next * (at(x, i + 1) - x[i]) - left * (x[i] - at(x, i - 1)));
    if (i == 0) continue;
    const double multiple = -h * h * left / middle[i - 1];
    middle[i] += multiple * h * h * left;
    right[i] -= multiple * right[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    v[i] = (right[i] + (i + 1 < n ? h * h * k[i + 1] * v[i + 1] : 0)) / middle[i];
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
