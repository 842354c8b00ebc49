// PARTIAL: turns radians into degrees
// SPDX-License-Identifier: MIT-0
#pragma once
#include <numbers>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + (180 / std::numbers::pi) * h * v;
  v = v + (180 / std::numbers::pi) * h * a;
}
