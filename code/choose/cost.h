// SPDX-License-Identifier: MIT-0
/// @file
/// The cost of a step in evaluations, of the acceleration and of its derivatives; and of how many
/// bodies its time is taken. The live figure of chapter 7 counts by this, too.
#pragma once
#include <cstddef>

#include "measure/evaluations.h"

inline constexpr std::size_t one_body = 1;                ///< each step waits for the last
inline constexpr std::size_t in_a_loop = 512;             ///< throughput
inline constexpr std::size_t beyond_the_cache = 100'000;  ///< memory

/// A step so short that nothing explodes while it is timed [s].
inline constexpr double brief_step = 1e-6;

/// The cost of the derivatives of a scene: one evaluation, or as many as it asks for them.
template <class Scene>
long jacobian_cost(const Scene& scene) {
  if constexpr (requires { scene.evaluations_of_jacobian(); }) {
    return scene.evaluations_of_jacobian();
  }
  return 1;
}

// [bill]
/// A scene that counts the evaluations of its acceleration, and as many again for the derivatives
/// of it that an implicit method asks for. The linear solve is not counted.
template <class Scene>
struct CostCounted : measure::Counted<Scene> {
  using measure::Counted<Scene>::Counted;

  /// Counts, and hands the derivatives on.
  template <class Vec, class Time, class Add>
  void jacobian(const Vec& x, const Vec& v, Time t, Add&& add) const {
    this->evaluations += jacobian_cost<Scene>(*this);
    Scene::jacobian(x, v, t, add);
  }
};
// [bill]
