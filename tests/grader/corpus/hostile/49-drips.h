// TIME_LIMIT: prints a letter every now and then, for ever
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cstdio>
#include <unistd.h>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (;;) {
    std::putchar('.');
    std::fflush(stdout);
    usleep(300'000);
  }
}
