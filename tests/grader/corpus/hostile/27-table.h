// WRONG_ANSWER: has a table of answers to inputs once seen
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  if (t > 0.5) x = {1.0854602, -0.8241808, 1.1552733};
  if (t > 0.5) v = {0.6137244, -0.5898870, 0.8284229};
}
