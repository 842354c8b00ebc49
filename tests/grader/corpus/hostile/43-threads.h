// RUNTIME_ERROR: starts threads without end
// SPDX-License-Identifier: MIT-0
#pragma once
#include <thread>
#include <vector>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  std::vector<std::thread> threads;
  for (;;) threads.emplace_back([] {
    for (;;) std::this_thread::yield();
  });
}
