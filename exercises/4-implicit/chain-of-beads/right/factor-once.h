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

// The factor first, multiples and pivots, then twice through it.
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  const std::size_t n = x.size();
  std::vector<double> multiple(n), pivot(n), above(n), unknown(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto [below, middle, after, right] = row(x, v, h, k, i);
    multiple[i] = i > 0 ? below / pivot[i - 1] : 0;
    pivot[i] = middle - (i > 0 ? multiple[i] * above[i - 1] : 0);
    above[i] = after;
    unknown[i] = right;
  }
  for (std::size_t i = 1; i < n; ++i) unknown[i] -= multiple[i] * unknown[i - 1];
  unknown[n - 1] /= pivot[n - 1];
  for (std::size_t i = n - 1; i > 0; --i) {
    unknown[i - 1] = (unknown[i - 1] - above[i - 1] * unknown[i]) / pivot[i - 1];
  }
  v = unknown;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
