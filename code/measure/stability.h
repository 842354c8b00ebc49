// SPDX-License-Identifier: MIT-0
/// @file
/// Where a method on a linear scene stops being stable.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "measure/eigenvalues.h"
#include "measure/run.h"

namespace measure {

// [radius]
/// The matrix of one step on a linear scene without a constant force.
///
/// Its columns are what the method makes of the unit vectors of all that it keeps: position and
/// velocity, and its memory if it has one.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  linear in x and v, one-dimensional
/// @param h  step size [s]
template <class Step, class Scene>
Eigen::MatrixXd step_matrix(Step step, const Scene& scene, double h) {
  auto memory = start(step, scenes::State<double>{1, 0}, h, scene);
  Eigen::MatrixXd matrix(memory.size(), memory.size());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    std::fill(memory.begin(), memory.end(), 0.0);
    memory[std::size_t(column)] = 1;
    advance(step, memory, 0.0, h, scene);
    std::copy(memory.begin(), memory.end(), matrix.col(column).begin());
  }
  return matrix;
}

/// The factor by which the worst start grows in one step, in the long run: the size of the largest
/// eigenvalue of the step's matrix.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  linear in x and v, one-dimensional
/// @param h  step size [s]
template <class Step, class Scene>
double spectral_radius(Step step, const Scene& scene, double h) {
  return largest_eigenvalue(step_matrix(step, scene, h));
}
// [radius]

/// Returns whether no start grows for ever; what is not a number does.
///
/// A method that keeps a spring swinging for ever has a factor of one up to rounding, which counts
/// as stable.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  linear in x and v, one-dimensional
/// @param h  step size [s]
template <class Step, class Scene>
bool is_stable(Step step, const Scene& scene, double h) {
  return spectral_radius(step, scene, h) <= 1 + 1e-12;
}

/// The largest stable step between `stable` and `unstable`, by bisection down to rounding.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  linear in x and v, one-dimensional
/// @param stable  a step that keeps the scene bounded [s]
/// @param unstable  a larger step that does not [s]
template <class Step, class Scene>
double stability_limit(Step step, const Scene& scene, double stable, double unstable) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (stable + unstable) / 2;
    (is_stable(step, scene, middle) ? stable : unstable) = middle;
  }
  return stable;
}

/// A limit in three digits, rounded down, since a step as long as what is written must hold.
///
/// @param limit  what was found by halving, which may be a little short of 2; zero and infinity
/// stay
inline double in_three_digits(double limit) {
  if (limit == 0 || std::isinf(limit)) return limit;
  const double hundredths = std::pow(10.0, 2 - std::floor(std::log10(limit)));
  return std::floor(limit * (1 + 1e-5) * hundredths) / hundredths;
}

}  // namespace measure
