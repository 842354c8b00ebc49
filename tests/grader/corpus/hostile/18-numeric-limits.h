// COMPILE_ERROR|WRONG_ANSWER: makes the rounding error large
// SPDX-License-Identifier: MIT-0
#pragma once
#include <limits>
#include "given.h"

template <>
struct std::numeric_limits<double> {
  static constexpr double epsilon() { return 1e300; }
};

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
