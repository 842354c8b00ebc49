// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

inline double stretch(int links, double frame, const Plan& how) {
  const double each = 9.81 * std::pow(frame / how.substeps, 2) / how.iterations;
  return each * links * links / 2;
}

// Every plan that could pay, from the fewest substeps on.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int substeps = 1; substeps <= 200; ++substeps) {
    for (int iterations = 1; iterations <= 2 * links; ++iterations) {
      const Plan next{substeps, iterations};
      const double price = substeps * (move + iterations * pull);
      if (price >= least || stretch(links, frame, next) > most) continue;
      least = price;
      best = next;
    }
  }
  return best;
}
