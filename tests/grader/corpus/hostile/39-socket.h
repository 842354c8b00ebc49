// RUNTIME_ERROR: opens a connection
// says: not allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include <sys/socket.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  socket(AF_INET, SOCK_STREAM, 0);
}
