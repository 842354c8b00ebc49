// SPDX-License-Identifier: MIT-0
/// @file
/// The energy that symplectic Euler keeps, and how far it lets a spring swing.
#pragma once
#include <cmath>
#include <type_traits>

#include "../cast.h"
#include "measure/methods/euler.h"
#include "measure/run.h"

/// The farthest that a spring swings in a number of steps.
inline double swing(const scenes::Spring<>& spring, double h, long steps) {
  double far = 0;
  auto s = spring.start();
  measure::run(measure::symplectic_euler, spring, s, h, steps, [&](double, const auto& now) {
    if (!(std::abs(now.x) <= far)) far = std::abs(now.x);
  });
  return far;
}

// [shadow]
/// The energy of a scene with `h/2 * v * a` added.
template <class Scene>
auto shadow_energy(const Scene& scene, double h) {
  return [&scene, h](const auto& x, const auto& v) {
    const std::decay_t<decltype(v)> a = scene(x, v, 0.0);
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(v)>>) {
      return scene.energy(x, v) + h / 2 * v * a;
    } else {
      return scene.energy(x, v) + h / 2 * v.dot(a);
    }
  };
}
// [shadow]
