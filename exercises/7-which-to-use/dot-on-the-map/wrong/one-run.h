// Fails: the growth of a step that swings is found
// Says: near, and not exact: is it measured in a run? Where that began still counts in it
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// How much one start has grown after a thousand steps, to the power of a thousandth.
inline double growth(const std::function<void(double& x, double& v)>& step) {
  double x0 = 0, v0 = 0, x = 1, v = 0;
  for (int n = 0; n < 1000; ++n) {
    step(x, v);
    step(x0, v0);
  }
  return std::pow(std::hypot(x - x0, v - v0), 1.0 / 1000);
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
