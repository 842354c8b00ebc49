// fails: the longest stable step of four methods is right to a millionth
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The columns are taken as if the rest were at zero.
inline double growth(const std::function<void(double& x, double& v)>& step) {
  double xx = 1, vx = 0, xv = 0, vv = 1;
  step(xx, vx);
  step(xv, vv);
  const double half_trace = (xx + vv) / 2, determinant = xx * vv - xv * vx;
  const double apart = half_trace * half_trace - determinant;
  return apart < 0 ? std::sqrt(determinant) : std::abs(half_trace) + std::sqrt(apart);
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
