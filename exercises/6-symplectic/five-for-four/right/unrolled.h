// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void part(Vec& x, Vec& v, Vec& a, double end, double h, const Acceleration& acceleration) {
  const Vec half = v + 0.5 * h * a;
  x = x + h * half;
  a = acceleration(x, half, end);
  v = half + 0.5 * h * a;
}

inline void step(Vec& x, Vec& v, Vec& a, double t, double h, const Acceleration& acceleration) {
  const double alpha = 1 / (4 - std::pow(4.0, 1.0 / 3.0)), beta = 1 - 4 * alpha;
  part(x, v, a, t + alpha * h, alpha * h, acceleration);
  part(x, v, a, t + 2 * alpha * h, alpha * h, acceleration);
  part(x, v, a, t + (2 * alpha + beta) * h, beta * h, acceleration);
  part(x, v, a, t + (3 * alpha + beta) * h, alpha * h, acceleration);
  part(x, v, a, t + h, alpha * h, acceleration);
}
