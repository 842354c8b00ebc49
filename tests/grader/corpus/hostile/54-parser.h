// COMPILE_LIMIT|COMPILE_ERROR: makes the parser try everything twice
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct x struct z<x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(x(y)))))))))))))))))))))))))))))))))))))))) n;

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
