// Fails: a machine that keeps up makes good a hitch
// Says: one step a frame, however long the frame was: the game runs slower wherever two are due
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// One step a frame is always cheap, and time is lost on every slow screen.
inline int steps_due(double& saved, double length, double h, int most) {
  saved += length;
  const int steps = saved >= h ? 1 : 0;
  saved = std::fmod(saved, h);
  return std::min(steps, most);
}

inline double settled_frame(double draw, double cost, double h, int most) {
  const double at_most = draw + most * cost;
  return cost < h ? std::min(draw / (1 - cost / h), at_most) : at_most;
}
