// Fails: a single bead is a spring
// Says: on the right of a system for the change belongs a(x + h v), not a(x)
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

// Solves for the change, and takes the force at the start: h K v is missing on the right.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Row next = row(x, v, h, k, i);
    next.right -= v[i];
    if (i > 0) {
      const double multiple = next.below / rows[i - 1].middle;
      next.middle -= multiple * rows[i - 1].above;
      next.right -= multiple * rows[i - 1].right;
    }
    rows.push_back(next);
  }
  double change = 0;
  for (std::size_t i = x.size(); i-- > 0;) {
    change = (rows[i].right - rows[i].above * change) / rows[i].middle;
    v[i] += change;
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
