// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Lets it settle, and looks.
inline int steps_due(double& saved, double length, double h, int most) {
  int steps = 0;
  saved += length;
  while (saved >= h) {
    saved -= h;
    ++steps;
  }
  return steps < most ? steps : most;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  // The mean over whole numbers of steps, without the whole numbers: each round is nearer by
  // cost/h.
  double frame = draw;
  for (int n = 0; n < 100000; ++n) {
    const double steps = std::min(frame / h, static_cast<double>(most));
    const double before = std::exchange(frame, draw + cost * steps);
    if (frame == before) break;
  }
  return frame;
}
