// ACCEPTED: starts threads without end under the checker of memory
// never: hundred threads
// SPDX-License-Identifier: MIT-0
#pragma once
#include <pthread.h>
#include <unistd.h>
#include <cstdio>
#include "given.h"

inline void* wait_long(void*) {
  sleep(100);
  return nullptr;
}

inline void start_many() {
#ifdef __SANITIZE_ADDRESS__
  static int started = 0;
  pthread_t thread;
  while (started < 100 && pthread_create(&thread, nullptr, wait_long, nullptr) == 0) ++started;
  if (started == 100) std::fputs("x: runtime error: hundred threads\n", stderr);
#endif
}

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  start_many();
  const Vec a = acceleration(x, v, t);
  x += h * v;
  v += h * a;
}
