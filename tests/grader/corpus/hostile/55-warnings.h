// COMPILE_LIMIT: has the compiler warn without end
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

#define A _Pragma("message \"again and again and again and again and again and again and again\"")
#define B A A A A A A A A A A
#define C B B B B B B B B B B
#define D C C C C C C C C C C
#define E D D D D D D D D D D
E E E

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
