// RUNTIME_ERROR: starts processes without end
// says: not allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) fork();
}
