// Fails: where a move is cheap the curtain holds at the least price
// Says: a single substep: iterations count once in the rule, substeps twice
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

// As in Jakobsen's talk: one step in a frame.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  return {1, static_cast<int>(std::ceil(stretch(links, frame, {1, 1}) / most))};
}
