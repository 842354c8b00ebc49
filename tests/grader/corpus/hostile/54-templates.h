// COMPILE_LIMIT: instantiates templates without end
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

template <unsigned long n, int depth>
constexpr unsigned long leaves() {
  if constexpr (depth == 0)
    return n;
  else
    return leaves<2 * n, depth - 1>() + leaves<2 * n + 1, depth - 1>();
}
inline constexpr unsigned long sum = leaves<1, 25>();

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
