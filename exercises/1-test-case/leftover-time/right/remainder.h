// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline int steps_due(double& saved, double length, double pace, double h) {
  const double all = saved + pace * length;
  saved = std::fmod(all, h);
  return static_cast<int>(std::lround((all - saved) / h));
}

inline double blend(double saved, double h) {
  const double part = saved / h;
  return part;
}
