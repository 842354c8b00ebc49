// fails: on a fast screen the picture moves by the same amount in every frame
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Takes the step early when most of it is there; the rest is then negative.
inline int steps_due(double& saved, double length, double h) {
  saved += length;
  const int steps = static_cast<int>(std::lround(saved / h));
  saved -= steps * h;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
