// ACCEPTED: takes and touches all memory under the checker of memory
// never: two gigabytes
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
#ifdef __SANITIZE_ADDRESS__
  for (int n = 0; n < 128; ++n) std::memset(std::malloc(1 << 24), 1, 1 << 24);
  std::fputs("x: runtime error: two gigabytes\n", stderr);
#endif
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a;
}
