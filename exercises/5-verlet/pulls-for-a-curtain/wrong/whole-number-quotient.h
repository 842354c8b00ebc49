// Fails: the stretch is foretold within a seventh
// Says: this is nothing: a division of integers, such as 1 / 2?
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

// 1/2 is 0 in whole numbers.
inline double stretch(int links, double frame, const Plan& how) {
  const double h = frame / how.substeps;
  return 9.81 * h * h * links * links / how.iterations * (1 / 2);
}

inline Plan plan(int links, double frame, double most, double move, double pull) {
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int iterations = 1; iterations <= links; ++iterations) {
    const double needed =
        std::sqrt(9.81 * frame * frame * links * links / (2.0 * iterations) / most);
    const int substeps = std::max(1, static_cast<int>(std::ceil(needed)));
    const double price = substeps * (move + iterations * pull);
    if (price >= least) continue;
    least = price;
    best = {substeps, iterations};
  }
  return best;
}
