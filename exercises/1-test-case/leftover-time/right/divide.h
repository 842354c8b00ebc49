// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline int steps_due(double& saved, double length, double pace, double h) {
  saved += length * pace;
  const int steps = static_cast<int>(saved / h);
  saved -= steps * h;
  return steps;
}

inline double blend(double saved, double h) {
  return saved / h;
}
