// ACCEPTED: lacks inline
// says: step lacks the word inline
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
