// fails: five steps under a hidden force are Euler's
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const float dt = static_cast<float>(h);
  const Vec a = acceleration(x, v, t);
  x += dt * v;
  v += dt * a;
}
