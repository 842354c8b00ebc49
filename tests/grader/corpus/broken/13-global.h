// ACCEPTED: has a global variable without inline
// says: last_energy lacks the word inline
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

double last_energy = 0;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
