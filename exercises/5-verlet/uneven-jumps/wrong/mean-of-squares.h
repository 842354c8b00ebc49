// fails: a throw passes through its true places, whatever the frames
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const Vec a = acceleration(x, v, t);
  const Vec next = x + h * v + (h * h + h_previous * h_previous) / 2 * a;
  x_previous = x;
  x = next;
}
