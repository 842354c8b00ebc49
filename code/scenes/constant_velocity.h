// SPDX-License-Identifier: MIT-0
/// @file
/// A body that nothing pushes: x'' = 0.
#pragma once
#include <Eigen/Core>

#include "scenes/state.h"

namespace scenes {

/// A body that nothing pushes: x'' = 0, in the plane.
/// @tparam Real  `double` or `float`
/// @see I. Newton, Philosophiae naturalis principia mathematica (1687), the first law of motion
template <class Real = double>
struct ConstantVelocity {
  using Vec = Eigen::Matrix<Real, 2, 1>;  ///< a point of the plane

  Vec start_position{Real(0), Real(0)};  ///< [m]
  Vec start_velocity{Real(1), Real(0)};  ///< [m/s]

  /// No acceleration, in any number of dimensions [m/s^2].
  /// @param v  velocity [m/s]; finite
  template <class V, class Time>
  constexpr V operator()(const V&, const V& v, Time) const {
    return Real(0) * v;
  }

  /// The start.
  State<Vec> start() const { return {start_position, start_velocity}; }

  /// The state at any time, also before the start.
  /// @param t  time since the start [s]
  State<Vec> exact(Real t) const { return {start_position + t * start_velocity, start_velocity}; }
};

}  // namespace scenes
