// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& x_previous, double t, double h, double h_previous,
                 const Acceleration& acceleration) {
  const Vec distance = x - x_previous;
  const Vec a = acceleration(x, (1 / h_previous) * distance, t);
  const Vec next = x + distance * (h / h_previous) + a * (0.5 * h * h + 0.5 * h * h_previous);
  x_previous = std::exchange(x, next);
}

inline Vec velocity(const Vec& x_previous, const Vec& x, const Vec& x_next, double h_previous,
                    double h) {
  const Vec before = (x - x_previous) / h_previous, after = (x_next - x) / h;
  return (h * before + h_previous * after) / (h_previous + h);
}
