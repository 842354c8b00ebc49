// TIME_LIMIT: ignores every signal and never ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include <csignal>

#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  for (int number = 1; number < 64; ++number) std::signal(number, SIG_IGN);
  for (volatile unsigned turn = 0;; turn = turn + 1) {
  }
}
