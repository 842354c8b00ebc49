// WRONG_ANSWER: turns a test framework off
// SPDX-License-Identifier: MIT-0
#define CATCH_CONFIG_DISABLE
#define CATCH_CONFIG_PREFIX_ALL
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
