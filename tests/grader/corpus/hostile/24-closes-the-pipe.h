// PROTOCOL_ERROR|INCOMPLETE|RUNTIME_ERROR: closes the way back
// SPDX-License-Identifier: MIT-0
#pragma once
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  close(3);
}
