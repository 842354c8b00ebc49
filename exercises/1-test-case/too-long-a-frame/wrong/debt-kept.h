// Fails: no frame takes more steps than it may, and a hitch is forgotten
// Says: the debt is kept, and the next frames have to pay it
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Stops at the limit and keeps the debt, so that after a hitch the game runs at the limit until all
// is paid, as cannon.js did (its pull request 392).
inline int steps_due(double& saved, double length, double h, int most) {
  saved += length;
  int steps = 0;
  for (; saved >= h && steps < most; saved -= h) ++steps;
  return steps;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
