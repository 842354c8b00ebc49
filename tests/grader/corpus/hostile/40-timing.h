// WRONG_ANSWER: tells by the time it takes what it was given
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline int calls = 0;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  if (++calls < 10) usleep(x.x > 0 ? 20000 : 1000);
}
