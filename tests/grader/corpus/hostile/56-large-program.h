// COMPILE_LIMIT: is a program of two gigabytes
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline char large[1u << 31];

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  large[0] = 1;
}
