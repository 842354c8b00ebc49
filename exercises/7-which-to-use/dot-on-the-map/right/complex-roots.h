// SPDX-License-Identifier: MIT-0
#pragma once
#include <complex>

#include "given.h"

struct Matrix {
  double a, b, c, d;
};

inline Matrix matrix_of(const std::function<void(double&, double&)>& step) {
  const auto from = [&](double x, double v) {
    step(x, v);
    return std::pair{x, v};
  };
  const auto rest = from(0, 0), right = from(1, 0), up = from(0, 1);
  return {right.first - rest.first, up.first - rest.first, right.second - rest.second,
          up.second - rest.second};
}

inline double growth(const std::function<void(double& x, double& v)>& step) {
  const auto [a, b, c, d] = matrix_of(step);
  const std::complex<double> root = std::sqrt(std::complex<double>((a - d) * (a - d) + 4 * b * c));
  return std::max(std::abs(a + d + root), std::abs(a + d - root)) / 2;
}

inline double longest_step(const std::function<void(double& x, double& v, double h)>& step,
                           double most) {
  double below = 0, above = most;
  for (int n = 0; n < 60; ++n) {
    const double h = n == 0 ? most : (below + above) / 2;
    const bool stable = growth([&](double& x, double& v) { step(x, v, h); }) <= 1 + 1e-9;
    if (stable) below = h;
    if (!stable) above = h;
  }
  return below;
}
