// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

using Column = std::vector<double>;

/// Solves a symmetric system with three diagonals in place: `right` becomes the unknowns.
/// @param diagonal  is used up
/// @param beside  beside[i] stands in row i, column i + 1, and below it in row i + 1, column i
inline void solve(Column& diagonal, const Column& beside, Column& right) {
  for (std::size_t i = 1; i < right.size(); ++i) {
    const double multiple = beside[i - 1] / diagonal[i - 1];
    diagonal[i] -= multiple * beside[i - 1];
    right[i] -= multiple * right[i - 1];
  }
  for (std::size_t i = right.size(); i-- > 0;) {
    if (i + 1 < right.size()) right[i] -= beside[i] * right[i + 1];
    right[i] /= diagonal[i];
  }
}

/// One step of backward Euler on a chain of beads of 1 kg each.
inline void step(Column& x, Column& v, double h, const Column& k) {
  Column diagonal(x.size(), 1), beside(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double pull = h * k[i] * (i > 0 ? x[i] - x[i - 1] : x[i]);
    v[i] -= pull;
    diagonal[i] += h * h * k[i];
    if (i == 0) continue;
    v[i - 1] += pull;
    diagonal[i - 1] += h * h * k[i];
    beside[i - 1] = -h * h * k[i];
  }
  solve(diagonal, beside, v);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
