// fails: half as long frames leave a quarter of the error on a spring
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const Vec next =
      x + h_previous / h * (x - x_previous) + h * (h + h_previous) / 2 * acceleration(x, v, t);
  x_previous = x;
  x = next;
}
