// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Gelfand's formula: the matrix squared sixty times, kept in size, tells how large its powers
// grow.
inline double growth(const std::function<void(double& x, double& v)>& step) {
  double x = 0, v = 0, a = 1, c = 0, b = 0, d = 1, logarithm = 0, power = 1;
  step(x, v);
  step(a, c);
  step(b, d);
  a -= x;
  b -= x;
  c -= v;
  d -= v;
  for (int n = 0; n < 60; ++n) {
    const double size = std::max({std::abs(a), std::abs(b), std::abs(c), std::abs(d)});
    if (size == 0) return 0;
    logarithm += std::log(size) * power;
    power /= 2;
    a /= size;
    b /= size;
    c /= size;
    d /= size;
    const double aa = a * a + b * c, bb = b * (a + d), cc = c * (a + d), dd = d * d + b * c;
    a = aa;
    b = bb;
    c = cc;
    d = dd;
  }
  return std::exp(logarithm);
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
