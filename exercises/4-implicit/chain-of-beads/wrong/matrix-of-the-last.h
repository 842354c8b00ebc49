// Fails: any chain ends where its slope leads back, short or long, soft or stiff, at rest or not
// Says: the matrix is kept from the last step, and another chain gets it, too
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

using Column = std::vector<double>;

// The eliminated diagonal is kept while the chain has as many beads and the step its length.
struct Eliminated {
  double h = 0;
  Column diagonal, multiple;
};

inline void eliminate(Eliminated& kept, double h, const Column& k) {
  if (kept.h == h && kept.diagonal.size() == k.size()) return;
  kept = {h, Column(k.size(), 1), Column(k.size())};
  for (std::size_t i = 0; i < k.size(); ++i) {
    kept.diagonal[i] += h * h * (k[i] + (i + 1 < k.size() ? k[i + 1] : 0));
    if (i == 0) continue;
    kept.multiple[i] = -h * h * k[i] / kept.diagonal[i - 1];
    kept.diagonal[i] += kept.multiple[i] * h * h * k[i];
  }
}

inline void step(Column& x, Column& v, double h, const Column& k) {
  static Eliminated kept;
  eliminate(kept, h, k);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double pull = h * k[i] * (i > 0 ? x[i] - x[i - 1] : x[i]);
    v[i] -= pull;
    if (i > 0) v[i - 1] += pull;
  }
  for (std::size_t i = 1; i < v.size(); ++i) v[i] -= kept.multiple[i] * v[i - 1];
  for (std::size_t i = v.size(); i-- > 0;) {
    if (i + 1 < v.size()) v[i] += h * h * k[i + 1] * v[i + 1];
    v[i] /= kept.diagonal[i];
  }
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * v[i];
}
