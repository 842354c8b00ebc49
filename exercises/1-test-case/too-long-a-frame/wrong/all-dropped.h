// Fails: no frame takes more steps than it may, and a hitch is forgotten
// Says: what is owed is cut to `most` steps: beyond them the part of a step is dropped, too, and only whole ones may be
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Drops the part of a step as well, and the picture jumps.
inline int steps_due(double& saved, double length, double h, int most) {
  saved += length;
  int steps = 0;
  for (; saved >= h && steps < most; saved -= h) ++steps;
  if (steps == most) saved = 0;
  return steps;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
