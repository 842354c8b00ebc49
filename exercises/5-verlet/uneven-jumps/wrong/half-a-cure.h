// fails: half as long frames leave a quarter of the error on a spring
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Published by Jonathan Dummer, and how matter.js 0.20 moves its bodies.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const Vec next = x + h / h_previous * (x - x_previous) + h * h * acceleration(x, v, t);
  x_previous = x;
  x = next;
}
