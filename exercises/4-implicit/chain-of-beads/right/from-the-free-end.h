// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The system for the new velocities: row i has below, middle and above.
struct Row {
  double below = 0, middle = 0, above = 0, right = 0;
};

inline Row row(const std::vector<double>& x, const std::vector<double>& v, double h,
               const std::vector<double>& k, std::size_t i) {
  const bool last = i + 1 == x.size();
  const double left = k[i], next = last ? 0 : k[i + 1];
  const double before = i > 0 ? x[i - 1] : 0, after = last ? 0 : x[i + 1];
  return {i > 0 ? -h * h * left : 0, 1 + h * h * (left + next), -h * h * next,
          v[i] + h * (next * (after - x[i]) - left * (x[i] - before))};
}

// Eliminates from the free end to the wall, for the change of velocity.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  const std::size_t n = x.size();
  std::vector<Row> rows(n);
  for (std::size_t i = n; i-- > 0;) {
    Row& here = rows[i];
    here = row(x, v, h, k, i);
    here.right -= here.middle * v[i] + (i > 0 ? here.below * v[i - 1] : 0);
    if (i + 1 == n) continue;
    here.right -= here.above * v[i + 1];
    here.middle -= here.above * rows[i + 1].below / rows[i + 1].middle;
    here.right -= here.above * rows[i + 1].right / rows[i + 1].middle;
  }
  double change = 0;
  for (std::size_t i = 0; i < n; ++i) {
    change = (rows[i].right - rows[i].below * change) / rows[i].middle;
    v[i] += change;
    x[i] += h * v[i];
  }
}
