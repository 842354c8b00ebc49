// fails: the length that frames settle at is foretold
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Below zero when a step costs more than it covers.
inline int steps_due(double& saved, double length, double h, int most) {
  const double all = saved + length;
  const double due = std::floor(all / h);
  saved = all - due * h;
  return static_cast<int>(std::min<double>(due, most));
}

inline double settled_frame(double draw, double cost, double h, int most) {
  return draw / (1 - cost / h);
}
