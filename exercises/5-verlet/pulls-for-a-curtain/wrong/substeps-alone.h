// Fails: where a move costs many pulls the curtain holds at the least price
// Says: a single iteration: each substep pays for its move again
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

// The chapter's advice, taken for a law: it counts pulls and no moves.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  return {static_cast<int>(std::ceil(std::sqrt(stretch(links, frame, {1, 1}) / most))), 1};
}
