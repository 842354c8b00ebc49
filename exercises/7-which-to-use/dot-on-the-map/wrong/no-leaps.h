// fails: the growth of a step that does not swing is found, leaps included
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The larger root is not always the one farther from zero.
inline double growth(const std::function<void(double& x, double& v)>& step) {
  double x0 = 0, v0 = 0, xx = 1, vx = 0, xv = 0, vv = 1;
  step(x0, v0);
  step(xx, vx);
  step(xv, vv);
  const double half_trace = (xx - x0 + vv - v0) / 2;
  const double determinant = (xx - x0) * (vv - v0) - (xv - x0) * (vx - v0);
  const double apart = half_trace * half_trace - determinant;
  return apart < 0 ? std::sqrt(determinant) : half_trace + std::sqrt(apart);
}
inline double longest_step(const std::function<void(double& x, double& v, double h)>& step,
                           double most) {
  const auto holds = [&](double h) {
    return growth([&](double& x, double& v) { step(x, v, h); }) <= 1 + 1e-9;
  };
  if (holds(most)) return most;
  double stable = 0, unstable = most;
  while (unstable - stable > 1e-7 * unstable) {
    const double h = (stable + unstable) / 2;
    (holds(h) ? stable : unstable) = h;
  }
  return stable;
}
