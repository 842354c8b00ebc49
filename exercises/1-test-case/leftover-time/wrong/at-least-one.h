// fails: on a fast screen the picture moves by the same amount in every frame
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A step in every frame, whether it is due or not.
inline int steps_due(double& saved, double length, double h) {
  saved += length;
  int steps = 0;
  do {
    saved -= h;
    ++steps;
  } while (saved >= h);
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
