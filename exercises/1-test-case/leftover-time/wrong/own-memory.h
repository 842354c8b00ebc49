// fails: uneven frames are paid with as many steps as fit into them
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps the time itself, and so starts the second level with the rest of the first.
inline int steps_due(double& saved, double length, double h) {
  static double kept = 0;
  kept += length;
  int steps = 0;
  for (; kept >= h; kept -= h) ++steps;
  saved = kept;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
