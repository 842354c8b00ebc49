// fails: a few steps of a sledge are braked after the push, by division
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// One brake for all directions.
inline void step(Vec& x, Vec& v, double t, double h, const Vec& along, double c_along,
                 double c_across, const Acceleration& push) {
  v += h * push(x, v, t);
  v = v / (1 + c_along * h);
  x += h * v;
}
