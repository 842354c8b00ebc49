// COMPILE_ERROR: includes what only Windows has
// says: exists only on Windows
// SPDX-License-Identifier: MIT-0
#pragma once
#include <windows.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}
