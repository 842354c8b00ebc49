// SPDX-License-Identifier: MIT-0
/// @file
/// The longest stable step on a spring, found by running the method.
#pragma once
#include <cmath>

#include "measure/run.h"
#include "scenes/spring.h"

namespace live {

/// One step on a spring, of a method that keeps x and v, by where it takes two starts.
///
/// What measure::step_matrix gives, without the size of a solver for any matrix in the page.
struct StepOnASpring {
  scenes::State<double> a{1, 0}, b{0, 1};

  /// By how much the step multiplies an area of places and velocities.
  double determinant() const { return a.x * b.v - b.x * a.v; }
  /// The size of the larger eigenvalue: by how much it multiplies what lasts.
  double largest_eigenvalue() const {
    const double middle = (a.x + b.v) / 2;
    const double apart = middle * middle - determinant();
    return apart < 0 ? std::sqrt(determinant()) : std::abs(middle) + std::sqrt(apart);
  }
  /// The spring whose exact motion takes the same step, if it swings; not a number if it does not.
  /// @param h  step size [s]
  scenes::Spring<> effective(double h) const {
    const double size = std::sqrt(determinant());
    const double decay = -std::log(size) / h;
    const double turn = std::acos((a.x + b.v) / (2 * size)) / h;
    const double omega = std::hypot(decay, turn);
    return {.omega = omega, .zeta = decay / omega};
  }
};

/// @param step  a method that keeps x and v
/// @param scene  a spring
/// @param h  step size [s]
template <class Step, class Scene>
StepOnASpring one_step(Step step, const Scene& scene, double h) {
  StepOnASpring found;
  step(found.a.x, found.a.v, 0.0, h, scene);
  step(found.b.x, found.b.v, 0.0, h, scene);
  return found;
}

/// The step at which the method loses the spring [s], as measure::stability_limit finds it.
/// @param stable  a step that is short enough [s]
/// @param unstable  one that is too long [s]
template <class Step, class Scene>
double step_limit(Step step, const Scene& scene, double stable, double unstable) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (stable + unstable) / 2;
    const bool grows = one_step(step, scene, middle).largest_eigenvalue() > 1 + 1e-12;
    (grows ? unstable : stable) = middle;
  }
  return stable;
}

}  // namespace live
