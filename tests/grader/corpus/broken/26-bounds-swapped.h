// RUNTIME_ERROR: hands std::clamp its bounds the wrong way round
// says: gives std::clamp its bounds in the wrong order
// SPDX-License-Identifier: MIT-0
#pragma once
#include <algorithm>

#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  x += std::clamp(h, 1.0, 0.0) * v;
  v += h * a;
}
