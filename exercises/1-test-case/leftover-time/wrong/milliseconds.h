// fails: uneven frames are paid with as many steps as fit into them
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Frames in milliseconds, steps in seconds.
inline int steps_due(double& saved, double length, double h) {
  saved += length * 1000;
  const int steps = static_cast<int>(saved / h);
  saved -= steps * h;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
