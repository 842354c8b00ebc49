// Fails: no frame takes more steps than it may, and a hitch is forgotten
// Says: the time is cut before it is counted, and so the part of a step is another
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Cuts the time before it is spent, as the loop of the chapter does: other steps, another rest.
inline int steps_due(double& saved, double length, double h, int most) {
  saved += std::min(length, most * h);
  int steps = 0;
  for (; saved >= h; saved -= h) ++steps;
  return steps;
}

inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
