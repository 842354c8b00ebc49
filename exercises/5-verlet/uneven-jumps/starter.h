// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of position Verlet, as long as the frame is. There is a bug in it.
/// @param x  position [m], advanced in place
/// @param x_previous  position one frame ago [m], advanced in place
/// @param t  time of x [s]
/// @param h  length of the frame that begins at x [s]
/// @param h_previous  length of the frame that led from x_previous to x [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]; v is the last distance over its time
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const double correction = h / h_previous;
  const Vec x_next = x + correction * (x - x_previous) + h * h * acceleration(x, v, t);
  x_previous = x;
  x = x_next;
}

/// The velocity at the middle one of three places [m/s]. And another bug.
/// @param x_previous, x, x_next  three places in a row [m]
/// @param h_previous  length of the frame from the first to the second [s]
/// @param h  length of the frame from the second to the third [s]
inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  return (x_next - x_previous) / (h_previous + h);
}
