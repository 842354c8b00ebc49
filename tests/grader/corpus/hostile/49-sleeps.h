// TIME_LIMIT: sleeps
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) sleep(1000);
}
