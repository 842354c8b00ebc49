// fails: an orbit gains the energy that Euler's method gives it
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The two lines swapped: what four well-known sources call Euler's method.
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  v += h * acceleration(x, v, t);
  x += h * v;
}
