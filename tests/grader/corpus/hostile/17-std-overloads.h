// WRONG_ANSWER|COMPILE_ERROR: puts comparisons into namespace std
// SPDX-License-Identifier: MIT-0
#pragma once
#include <cmath>
#include "given.h"

namespace std {
inline bool isless(Vec, Vec) { return true; }
inline bool operator<=(const Vec&, const Vec&) { return true; }
inline double abs(const Vec&) { return 0; }
inline double fabs(Vec) { return 0; }
}  // namespace std

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
