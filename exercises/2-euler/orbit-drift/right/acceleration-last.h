// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec velocity = v;
  v += acceleration(x, v, t) * h;
  x += velocity * h;
}
