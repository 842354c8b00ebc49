// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

struct Weights {
  double first, second;
};

constexpr Weights weights(double alpha) {
  return {(2 * alpha - 1) / (2 * alpha), 1 / (2 * alpha)};
}

inline void step(Vec& x, Vec& v, double t, double h, double alpha,
                 const Acceleration& acceleration) {
  const Vec slopes[2] = {v, v + alpha * h * acceleration(x, v, t)};
  const Vec a = (slopes[1] - slopes[0]) / (alpha * h);
  const Vec then = acceleration(x + h * alpha * v, slopes[1], t + h * alpha);
  const auto [first, second] = weights(alpha);
  x += first * h * slopes[0] + second * h * slopes[1];
  v += first * h * a + second * h * then;
}
