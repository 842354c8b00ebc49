// Fails: a machine too slow for its steps slows the game and not the screen
// Says: nothing limits the steps, so that each frame takes longer than the one before: the game hangs
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The loop without a limit: every frame owes more than the one before.
inline int steps_due(double& saved, double length, double h, int most) {
  saved += length;
  int steps = 0;
  for (; saved >= h; saved -= h) ++steps;
  return steps;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
