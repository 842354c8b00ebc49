// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Both lines as two equations for the new x and v, by Cramer's rule.
inline void step(double& x, double& v, double h, double omega, double zeta) {
  const double half = h / 2, pull = half * omega * omega, brake = h * zeta * omega;
  const double first = x + half * v, second = (1 - brake) * v - pull * x;
  const double determinant = 1 + brake + half * pull;
  x = ((1 + brake) * first + half * second) / determinant;
  v = (second - pull * first) / determinant;
}

inline double told(double omega, double h) {
  // The tangent of half an angle, by the whole one.
  return 2 / h * std::sin(omega * h) / (1 + std::cos(omega * h));
}
