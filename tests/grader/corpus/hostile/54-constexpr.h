// COMPILE_LIMIT: computes without end as it compiles
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

constexpr long count() {
  long sum = 0;
  for (long n = 0; n < (1L << 60); ++n) sum += n;
  return sum;
}
inline constexpr long sum = count();

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
