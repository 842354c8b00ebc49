// PARTIAL|WRONG_ANSWER: throws dice
// says: your answer is random
// SPDX-License-Identifier: MIT-0
#pragma once
#include <random>

#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  static const double luck = 1e-3 * std::random_device{}() / 4294967296.0;
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + (1 + luck) * h * a;
}
