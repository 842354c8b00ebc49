// RUNTIME_ERROR: names a loader that there is not, so that the cage cannot start it
// says: does not start your program
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

__asm__(".section .interp,\"a\",@progbits\n.asciz \"/nonexistent\"\n.text");

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a;
}
