// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// How many steps are due in a frame: at most `most`. Whole steps beyond that are dropped.
/// @param saved  time that the frames before left over [s]; leaves what is less than a step
/// @param length  how long the frame took [s], 0 or more
/// @param h  step size [s]
/// @param most  most steps of a frame, at least 1
inline int steps_due(double& saved, double length, double h, int most) {
  const double all = saved + length;
  const double due = std::floor(all / h);
  saved = all - due * h;
  return static_cast<int>(std::min<double>(due, most));
}

/// How long frames are, on average, when they have settled [s].
/// @param draw  what a frame takes without any step [s], above 0
/// @param cost  what each step adds to it [s], 0 or more
/// @param h  step size [s]
/// @param most  most steps of a frame, at least 1
inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
