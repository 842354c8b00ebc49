// RUNTIME_ERROR: throws an exception
// says: the orbit was lost
// never: overflow
// SPDX-License-Identifier: MIT-0
#pragma once
#include <stdexcept>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  throw std::runtime_error("the orbit was lost");
}
