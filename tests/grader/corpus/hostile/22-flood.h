// PROTOCOL_ERROR|OUTPUT_LIMIT|TIME_LIMIT: answers without end
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const double more[512] = {};
  for (;;) (void)!write(3, more, sizeof more);
}
