// Fails: the longest stable step of four methods is right to a millionth
// Says: this is 2/omega, the limit of symplectic Euler without damping, and not this method's
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline double growth(const std::function<void(double& x, double& v)>& step) {
  double x0 = 0, v0 = 0, xx = 1, vx = 0, xv = 0, vv = 1;
  step(x0, v0);
  step(xx, vx);
  step(xv, vv);
  const double half_trace = (xx - x0 + vv - v0) / 2;
  const double determinant = (xx - x0) * (vv - v0) - (xv - x0) * (vx - v0);
  const double apart = half_trace * half_trace - determinant;
  return apart < 0 ? std::sqrt(determinant) : std::abs(half_trace) + std::sqrt(apart);
}

// The wall's rule for symplectic Euler, whatever the method.
inline double longest_step(const std::function<void(double& x, double& v, double h)>& step,
                           double most) {
  double x0 = 0, v0 = 0, x = 1, v = 0;
  const double h = 1e-6;
  step(x0, v0, h);
  step(x, v, h);
  return std::min(most, 2 / std::sqrt(std::abs((v - v0) / h)));
}
