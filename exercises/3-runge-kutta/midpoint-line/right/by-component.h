// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  const Vec middle[2] = {x + (h / 2) * v, v + (h / 2) * a};
  const Vec there = acceleration(middle[0], middle[1], t + h / 2);
  x.x += h * middle[1].x;
  x.y += h * middle[1].y;
  x.z += h * middle[1].z;
  v.x += h * there.x;
  v.y += h * there.y;
  v.z += h * there.z;
}
