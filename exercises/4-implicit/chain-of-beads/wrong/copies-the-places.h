// Fails: a hundred thousand beads take a step in the time that there is
// Says: work that grows faster than what it is asked for
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The system for the new velocities: row i has below, middle and above.
struct Row {
  double below = 0, middle = 0, above = 0, right = 0;
};

inline Row row(std::vector<double> x, const std::vector<double>& v, double h,
               const std::vector<double>& k, std::size_t i) {
  const bool last = i + 1 == x.size();
  const double left = k[i], next = last ? 0 : k[i + 1];
  const double before = i > 0 ? x[i - 1] : 0, after = last ? 0 : x[i + 1];
  return {i > 0 ? -h * h * left : 0, 1 + h * h * (left + next), -h * h * next,
          v[i] + h * (next * (after - x[i]) - left * (x[i] - before))};
}

// Three diagonals, and a copy of all places for each row.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  const std::size_t n = x.size();
  std::vector<Row> rows;
  for (std::size_t i = 0; i < n; ++i) rows.push_back(row(x, v, h, k, i));
  for (std::size_t i = 1; i < n; ++i) {
    const double multiple = rows[i].below / rows[i - 1].middle;
    rows[i].middle -= multiple * rows[i - 1].above;
    rows[i].right -= multiple * rows[i - 1].right;
  }
  for (std::size_t i = n; i-- > 0;) {
    v[i] = (rows[i].right - (i + 1 < n ? rows[i].above * v[i + 1] : 0)) / rows[i].middle;
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
