// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void add(Vec& to, double h, const Vec& rate) {
  to.x += h * rate.x;
  to.y += h * rate.y;
  to.z += h * rate.z;
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  add(v, h, a);
  add(x, h, v);
}

inline void undo(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  add(x, -h, v);
  const Vec a = acceleration(x, v, t);
  add(v, -h, a);
}
