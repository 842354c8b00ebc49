// COMPILE_ERROR: embeds a file of the machine
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline const unsigned char secret[] = {
#embed "/etc/passwd"
};

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
}
