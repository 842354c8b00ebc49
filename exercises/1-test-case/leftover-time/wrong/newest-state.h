// fails: on a fast screen the picture moves by the same amount in every frame
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Always draws the newest state.
inline int steps_due(double& saved, double length, double h) {
  saved += length;
  int steps = 0;
  for (; saved >= h; saved -= h) ++steps;
  return steps;
}

inline double blend(double saved, double h) {
  return 1;
}
