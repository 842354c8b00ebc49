// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// How a frame is spent on a rope.
struct Plan {
  int substeps = 1;
  int iterations = 1;
};

/// How much too long a rope hangs in the end [m].
inline double stretch(int links, double frame, const Plan& how) {
  const double h = frame / how.substeps;
  return 9.81 * h * h * links * links / (2.0 * how.iterations);
}

/// The cheapest plan that leaves no more than is allowed.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  const auto price = [&](const Plan& how) { return how.substeps * (move + how.iterations * pull); };
  const auto enough = [&](int iterations) {
    const double substeps = std::sqrt(stretch(links, frame, {1, iterations}) / most);
    return Plan{std::max(1, static_cast<int>(std::ceil(substeps))), iterations};
  };
  Plan best = enough(1);
  for (int iterations = 2; iterations <= links; ++iterations) {
    const Plan next = enough(iterations);
    if (price(next) < price(best)) best = next;
  }
  return best;
}
