// fails: on a slow screen several steps are due in a frame, and the rest is kept
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The rest of each frame is lost, and the game runs slow.
inline int steps_due(double& saved, double length, double h) {
  saved += length;
  const int steps = static_cast<int>(saved / h);
  saved = 0;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
