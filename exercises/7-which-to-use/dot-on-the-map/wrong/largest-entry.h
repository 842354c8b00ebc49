// fails: the growth of a step that swings is found
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A norm: how far one step can carry a start, and not what many do.
inline double growth(const std::function<void(double& x, double& v)>& step) {
  double x0 = 0, v0 = 0, xx = 1, vx = 0, xv = 0, vv = 1;
  step(x0, v0);
  step(xx, vx);
  step(xv, vv);
  return std::max(std::abs(xx - x0) + std::abs(xv - x0), std::abs(vx - v0) + std::abs(vv - v0));
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
