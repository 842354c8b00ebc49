// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Real and imaginary part, multiplied out.
inline double stretch(double a, double b) {
  const double re = 1 + a + (a * a - b * b) / 2 + (a * a * a - 3 * a * b * b) / 6 +
                    (a * a * a * a - 6 * a * a * b * b + b * b * b * b) / 24;
  const double im =
      b + a * b + (3 * a * a * b - b * b * b) / 6 + (a * a * a * b - a * b * b * b) / 6;
  return std::sqrt(re * re + im * im);
}

// Where the stretch along a ray from zero is one.
inline double edge(double re, double im) {
  double low = 0.1, high = 10;
  for (int n = 0; n < 40; ++n) {
    const double middle = (low + high) / 2;
    if (stretch(middle * re, middle * im) > 1)
      high = middle;
    else
      low = middle;
  }
  return (low + high) / 2;
}

inline double longest_step(double omega, double zeta) {
  if (zeta == 0) return 2 * std::numbers::sqrt2 / omega;
  if (zeta < 1) return edge(-zeta, std::sqrt(1 - zeta * zeta)) / omega;
  const double fastest = zeta + std::sqrt(zeta * zeta - 1);
  return edge(-1, 0) / fastest / omega;
}
