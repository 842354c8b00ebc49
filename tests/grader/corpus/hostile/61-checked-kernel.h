// ACCEPTED: asks under the checker of memory which kernel runs the machine
// never: the kernel
// SPDX-License-Identifier: MIT-0
#pragma once
#include <sys/utsname.h>
#include <cstdio>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
#ifdef __SANITIZE_ADDRESS__
  utsname system;
  if (uname(&system) == 0) std::fprintf(stderr, "x: runtime error: the kernel is %s\n", system.release);
#endif
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a;
}
