// RUNTIME_ERROR: reads another process's memory
// says: not allowed
// SPDX-License-Identifier: MIT-0
#pragma once
#include <sys/uio.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  char there[64];
  iovec local{there, sizeof there}, remote{reinterpret_cast<void*>(0x400000), sizeof there};
  process_vm_readv(1, &local, 1, &remote, 1, 0);
}
