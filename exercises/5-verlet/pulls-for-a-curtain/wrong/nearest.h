// Fails: where a move is cheap the curtain holds at the least price
// Says: the substeps are rounded to the nearest whole number: with so many iterations it takes more substeps at times
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

// Rounded to the nearest, which at times is below.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int iterations = 1; iterations <= links; ++iterations) {
    const double needed = std::sqrt(stretch(links, frame, {1, iterations}) / most);
    const int substeps = std::max(1, static_cast<int>(std::lround(needed)));
    const double price = substeps * (move + iterations * pull);
    if (price >= least) continue;
    least = price;
    best = {substeps, iterations};
  }
  return best;
}
