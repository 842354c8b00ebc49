// COMPILE_ERROR: takes a file of the machine into its program
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

asm(".incbin \"/etc/passwd\"");

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
