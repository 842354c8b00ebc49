// RUNTIME_ERROR: leaves a daemon that writes later
// says: not allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  if (daemon(1, 1) == 0) {
    sleep(2);
    double answer[32] = {2, 30};
    (void)!write(3, answer, sizeof answer);
  }
}
