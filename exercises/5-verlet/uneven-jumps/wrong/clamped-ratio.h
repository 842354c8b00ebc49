// fails: a throw passes through its true places, whatever the frames
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A guard against hiccups, which are what the correction is for.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const double ratio = std::clamp(h / h_previous, 0.5, 2.0);
  const Vec next = x + ratio * (x - x_previous) + h * (h + h_previous) / 2 * acceleration(x, v, t);
  x_previous = x;
  x = next;
}
