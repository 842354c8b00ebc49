// fails: a throw passes through its true places, whatever the frames
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const Vec next = x + h * (v + h_previous * acceleration(x, v, t));
  x_previous = x;
  x = next;
}
