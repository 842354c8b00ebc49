// COMPILE_ERROR: uses what came with C++23
// says: compiled as C++20
// SPDX-License-Identifier: MIT-0
#pragma once
#include <print>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  std::println("{}", t);
  x = x + h * v;
  v = v + h * a;
}
