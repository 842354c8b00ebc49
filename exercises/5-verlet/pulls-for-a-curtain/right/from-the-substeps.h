// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Plan {
  int substeps = 1;
  int iterations = 1;
};

inline double stretch(int links, double frame, const Plan& how) {
  const double n = links, h = frame / how.substeps, q = how.iterations;
  return n * n * 9.81 * h * h / (2 * q);
}

// For each number of substeps, the iterations that it takes; more than one iteration alone needs
// is never worth it.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  std::vector<Plan> plans;
  for (int substeps = 1;; ++substeps) {
    const double needed = stretch(links, frame, {substeps, 1}) / most;
    plans.push_back({substeps, static_cast<int>(std::ceil(needed))});
    if (plans.back().iterations == 1) break;
  }
  return *std::min_element(plans.begin(), plans.end(), [&](const Plan& a, const Plan& b) {
    return a.substeps * (move + a.iterations * pull) < b.substeps * (move + b.iterations * pull);
  });
}
