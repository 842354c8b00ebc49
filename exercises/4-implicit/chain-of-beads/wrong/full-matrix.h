// Fails: a hundred thousand beads take a step in the time that there is
// Says: asked for memory that there is not
// Known: no, it ends before it has an answer
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

// Every zero is kept and worked on.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  const std::size_t n = x.size();
  std::vector<double> matrix(n * n);
  std::vector<double> right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Row from = row(x, v, h, k, i);
    if (i > 0) matrix[i * n + i - 1] = from.below;
    matrix[i * n + i] = from.middle;
    if (i + 1 < n) matrix[i * n + i + 1] = from.above;
    right[i] = from.right;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const double multiple = matrix[j * n + i] / matrix[i * n + i];
      for (std::size_t c = i; c < n; ++c) matrix[j * n + c] -= multiple * matrix[i * n + c];
      right[j] -= multiple * right[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t c = i + 1; c < n; ++c) right[i] -= matrix[i * n + c] * right[c];
    right[i] /= matrix[i * n + i];
  }
  v = right;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
