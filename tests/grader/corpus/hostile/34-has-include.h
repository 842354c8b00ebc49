// WRONG_ANSWER: asks the preprocessor which files there are
// SPDX-License-Identifier: MIT-0
#pragma once
#if __has_include("/etc/passwd") || __has_include("/etc/shadow") || __has_include("/proc/self/maps")
#error found one
#endif
#if __has_include("../solution.h") || __has_include("solution.h") || __has_include("judge.cpp")
#error found one
#endif
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
