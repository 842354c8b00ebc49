// Fails: at every frame rate the curtain holds at the least price
// Says: the iterations are paid once in a frame here, and not in each substep; and the rule is the one with n (n - 1)
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

inline double stretch(int links, double frame, const Plan& how) {
  const double h = frame / how.substeps;
  return 9.81 * h * h * links * (links - 1) / (2.0 * how.iterations);
}

// The iterations are counted as if the substeps shared them, and the rule is the sharper one.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int iterations = 1; iterations <= links; ++iterations) {
    const double needed = std::sqrt(stretch(links, frame, {1, iterations}) / most);
    const int substeps = std::max(1, static_cast<int>(std::ceil(needed)));
    const double price = substeps * move + iterations * pull;
    if (price >= least) continue;
    least = price;
    best = {substeps, iterations};
  }
  return best;
}
