// REJECTED: brings its own main
// says: remove main()
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x = x + h * v;
  v = v + h * a;
}

int main() { return 0; }
