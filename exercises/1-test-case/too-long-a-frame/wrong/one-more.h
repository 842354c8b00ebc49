// Fails: no frame takes more steps than it may, and a hitch is forgotten
// Says: more steps than a frame may take: is there a limit at all, and is it `most`?
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// <= where < is meant.
inline int steps_due(double& saved, double length, double h, int most) {
  saved += length;
  int steps = 0;
  for (; saved >= h && steps <= most; saved -= h) ++steps;
  saved = std::fmod(saved, h);
  return steps;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
