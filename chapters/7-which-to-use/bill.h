// SPDX-License-Identifier: MIT-0
/// @file
/// What a step is charged: evaluations, of the acceleration and of its derivatives.
#pragma once
#include "measure/evaluations.h"

/// What the derivatives of a scene are billed: one evaluation, or as many as it asks for them.
template <class Scene>
long bill_for_derivatives(const Scene& scene) {
  if constexpr (requires { scene.evaluations_of_jacobian(); }) {
    return scene.evaluations_of_jacobian();
  }
  return 1;
}

// [bill]
/// A scene that charges for its acceleration, and as much again for the derivatives of it that an
/// implicit method asks for. Solving the equations is on the house.
template <class Scene>
struct Billed : measure::Counted<Scene> {
  using measure::Counted<Scene>::Counted;

  /// Charges, and hands the derivatives on.
  template <class Vec, class Time, class Add>
  void jacobian(const Vec& x, const Vec& v, Time t, Add&& add) const {
    this->evaluations += bill_for_derivatives<Scene>(*this);
    Scene::jacobian(x, v, t, add);
  }
};
// [bill]
