// RUNTIME_ERROR: kills everything it can reach
// says: not allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include <signal.h>
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  kill(-1, SIGKILL);
}
