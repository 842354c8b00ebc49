// fails: uneven frames are paid with as many steps as fit into them
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// One sign: what was saved is written over. A step that a frame missed was dropped like this in
// nphysics-ecs-dumb (its pull request 13).
inline int steps_due(double& saved, double length, double h) {
  saved = length;
  int steps = 0;
  for (; saved >= h; saved -= h) ++steps;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
