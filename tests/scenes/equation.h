// SPDX-License-Identifier: MIT-0
// Whether an exact solution obeys the equation of its scene.
#pragma once
#include <algorithm>
#include <cmath>
#include <type_traits>

namespace equation {

template <class Vec>
long double length(const Vec& x) {
  if constexpr (std::is_arithmetic_v<Vec>) {
    return std::abs(x);
  } else {
    return x.norm();
  }
}

// The derivative of f by central differences of order 8.
template <class F>
auto slope(F f, long double t) {
  constexpr long double h = 0.001L;
  constexpr long double weights[] = {4 / 5.0L, -1 / 5.0L, 4 / 105.0L, -1 / 280.0L};
  decltype(f(t)) sum = (weights[0] / h) * (f(t + h) - f(t - h));
  for (int n = 2; n <= 4; ++n) {
    sum = sum + (weights[n - 1] / h) * (f(t + n * h) - f(t - n * h));
  }
  return sum;
}

// How far exact(t) is from x' = v and v' = a(x, v, t). For scenes in long double.
template <class Scene>
long double residual(const Scene& scene, long double t) {
  using Vec = typename Scene::Vec;
  const auto x = [&](long double s) -> Vec { return scene.exact(s).x; };
  const auto v = [&](long double s) -> Vec { return scene.exact(s).v; };
  const Vec a = scene(x(t), v(t), t);
  return std::max(length<Vec>(slope(x, t) - v(t)), length<Vec>(slope(v, t) - a));
}

// Whether exact(0) is the start.
template <class Scene>
bool begins_at_start(const Scene& scene) {
  const auto now = scene.exact(0);
  const auto start = scene.start();
  return now.x == start.x && now.v == start.v;
}

}  // namespace equation
