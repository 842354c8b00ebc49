// SPDX-License-Identifier: MIT-0
/// @file
/// What chapter 6 steps sixty times a second, and the energy that symplectic Euler keeps of it.
#pragma once
#include <cmath>
#include <numbers>
#include <type_traits>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/circle.h"
#include "scenes/spring.h"

inline constexpr double frame = 1.0 / 60;  ///< the step of the chapter [s]

/// The drone of chapter 2: ten metres from its tower, once round in eight seconds.
inline constexpr scenes::Circle<> drone{.omega = 2 * std::numbers::pi / 8, .radius = 10};

/// The suspension of a toy car, three swings a second, without its damper.
inline constexpr scenes::Spring<> suspension{.omega = 20, .zeta = 0, .x0 = 0.1};

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
