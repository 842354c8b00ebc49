// Fails: a hundred thousand beads take a step in the time that there is
// Says: an iteration that was ended too soon?
// Known: no, it is called with chains too long to be gone through again
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

// Gauss and Seidel's iteration, as often as looked enough on a short soft chain.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < x.size(); ++i) rows.push_back(row(x, v, h, k, i));
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double before = i > 0 ? rows[i].below * v[i - 1] : 0;
      const double after = i + 1 < x.size() ? rows[i].above * v[i + 1] : 0;
      v[i] = (rows[i].right - before - after) / rows[i].middle;
    }
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
