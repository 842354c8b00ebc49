// SPDX-License-Identifier: MIT-0
/// @file
/// The longest stable step on a spring, found by running the method.
#pragma once
#include <cmath>

#include "measure/run.h"

namespace live {

/// The size of the larger eigenvalue of one step on a spring, of a method that keeps x and v.
///
/// What measure::spectral_radius gives, without the size of a solver for any matrix in the page.
template <class Step, class Scene>
double largest_eigenvalue(Step step, const Scene& scene, double h) {
  scenes::State<double> a{1, 0}, b{0, 1};
  step(a.x, a.v, 0.0, h, scene);
  step(b.x, b.v, 0.0, h, scene);
  const double middle = (a.x + b.v) / 2;
  const double determinant = a.x * b.v - b.x * a.v;
  const double apart = middle * middle - determinant;
  return apart < 0 ? std::sqrt(determinant) : std::abs(middle) + std::sqrt(apart);
}

/// The step at which the method loses the spring [s], as measure::stability_limit finds it.
/// @param stable  a step that is short enough [s]
/// @param unstable  one that is too long [s]
template <class Step, class Scene>
double step_limit(Step step, const Scene& scene, double stable, double unstable) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (stable + unstable) / 2;
    (largest_eigenvalue(step, scene, middle) > 1 + 1e-12 ? unstable : stable) = middle;
  }
  return stable;
}

}  // namespace live
