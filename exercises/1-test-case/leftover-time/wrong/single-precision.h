// fails: uneven frames are paid with as many steps as fit into them
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline int steps_due(double& saved, double length, double h) {
  float rest = static_cast<float>(saved + length);
  int steps = 0;
  for (; rest >= h; rest -= static_cast<float>(h)) ++steps;
  saved = rest;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
