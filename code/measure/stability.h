// SPDX-License-Identifier: MIT-0
/// @file
/// Where a method on a linear scene stops being stable.
#pragma once
#include <Eigen/Eigenvalues>

#include "measure/run.h"

namespace measure {

// [radius]
/// The factor by which the worst start grows in one step, in the long run.
///
/// A step on a linear scene without a constant force is a matrix. Its columns are what the method
/// makes of the starts (1, 0) and (0, 1); the factor is the size of its largest eigenvalue.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  linear in x and v, one-dimensional
/// @param h  step size [s]
template <class Step, class Scene>
double spectral_radius(Step step, const Scene& scene, double h) {
  const scenes::State<double> column1 = after(step, scene, scenes::State<double>{1, 0}, h, 1);
  const scenes::State<double> column2 = after(step, scene, scenes::State<double>{0, 1}, h, 1);
  const Eigen::Matrix2d matrix{{column1.x, column2.x}, {column1.v, column2.v}};
  return matrix.eigenvalues().cwiseAbs().maxCoeff();
}
// [radius]

// [limit]
/// The largest stable step between `stable` and `unstable`, by bisection down to rounding.
///
/// A method that keeps a spring swinging for ever has a factor of one up to rounding, which counts
/// as stable.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  linear in x and v, one-dimensional
/// @param stable  a step that keeps the scene bounded [s]
/// @param unstable  a larger step that does not [s]
template <class Step, class Scene>
double stability_limit(Step step, const Scene& scene, double stable, double unstable) {
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (stable + unstable) / 2;
    (spectral_radius(step, scene, middle) > 1 + 1e-12 ? unstable : stable) = middle;
  }
  return stable;
}
// [limit]

}  // namespace measure
