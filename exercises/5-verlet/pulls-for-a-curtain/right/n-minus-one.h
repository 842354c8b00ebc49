// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

// Before it is shortened for many links; exact with one iteration.
inline double stretch(int links, double frame, const Plan& how) {
  const double h = frame / how.substeps;
  return 9.81 * h * h * links * (links - 1) / (2.0 * how.iterations);
}

inline Plan plan(int links, double frame, double most, double move, double pull) {
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int iterations = 1; iterations <= links; ++iterations) {
    Plan next{1, iterations};
    while (stretch(links, frame, next) > most) ++next.substeps;
    const double price = next.substeps * (move + iterations * pull);
    if (price >= least) continue;
    least = price;
    best = next;
  }
  return best;
}
