// ACCEPTED: starts processes under the checker of memory
// never: second process
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include <cstdio>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
#ifdef __SANITIZE_ADDRESS__
  if (fork() >= 0) std::fputs("x: runtime error: second process\n", stderr);
#endif
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a;
}
