// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of position Verlet, as long as the frame is.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const double between_middles = (h + h_previous) / 2;
  const Vec x_next = x + h * (v + between_middles * acceleration(x, v, t));
  x_previous = x;
  x = x_next;
}
