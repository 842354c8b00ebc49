// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

// Adds up what each link gives, with the point at its end: a little much, and within the seventh.
inline double stretch(int links, double frame, const Plan& how) {
  const double h = frame / how.substeps;
  double sum = 0;
  for (int points = 1; points <= links; ++points) sum += points * 9.81 * h * h / how.iterations;
  return sum;
}

// By the rule, which has the square for that sum.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  const double whole = 9.81 * frame * frame * links * links / 2;
  Plan best;
  double least = std::numeric_limits<double>::infinity();
  for (int iterations = links; iterations >= 1; --iterations) {
    const int substeps = static_cast<int>(std::ceil(std::sqrt(whole / (iterations * most))));
    const double price = substeps * (move + iterations * pull);
    if (price >= least) continue;
    least = price;
    best = {substeps, iterations};
  }
  return best;
}
