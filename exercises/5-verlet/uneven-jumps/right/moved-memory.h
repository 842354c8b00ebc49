// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Moves the old place to where an equal frame would have begun, and takes the formula for equal
// ones.
inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec v = (x - x_previous) / h_previous;
  const Vec a = acceleration(x, v, t);
  const Vec v_now = v + h_previous / 2 * a;
  const Vec before = x - h * v_now + h * h / 2 * a;
  const Vec next = 2 * x - before + h * h * a;
  x_previous = x;
  x = next;
}

// By the parabola through the three places, in Lagrange's form.
inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  const double both = h_previous + h;
  return -h / (h_previous * both) * x_previous + (h - h_previous) / (h_previous * h) * x +
         h_previous / (h * both) * x_next;
}
