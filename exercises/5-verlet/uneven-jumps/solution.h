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

/// The velocity at the middle one of three places.
inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  const Vec before = (x - x_previous) / h_previous, after = (x_next - x) / h;
  return (h * before + h_previous * after) / (h_previous + h);
}
