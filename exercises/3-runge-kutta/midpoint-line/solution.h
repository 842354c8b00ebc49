// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of order two that looks a share of the step ahead.
inline void step(Vec& x, Vec& v, double t, double h, double alpha,
                 const Acceleration& acceleration) {
  const Vec a = acceleration(x, v, t);
  const Vec x_ahead = x + alpha * h * v;
  const Vec v_ahead = v + alpha * h * a;
  const Vec a_ahead = acceleration(x_ahead, v_ahead, t + alpha * h);
  const double second = 1 / (2 * alpha), first = 1 - second;
  x = x + h * (first * v + second * v_ahead);
  v = v + h * (first * a + second * a_ahead);
}
