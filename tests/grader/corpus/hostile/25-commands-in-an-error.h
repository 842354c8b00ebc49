// COMPILE_ERROR: has them in the compiler's message
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

#error ::error::owned ##[endgroup] <script>alert(1)</script> ]]> ``` [2J

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
