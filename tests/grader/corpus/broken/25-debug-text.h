// ACCEPTED: prints what it does
// SPDX-License-Identifier: MIT-0
#pragma once
#include <iostream>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
  std::cout << "step " << t << " nan " << 0 / x.x << '\n';
}
