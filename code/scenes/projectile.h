// SPDX-License-Identifier: MIT-0
/// @file
/// A cannonball in a vacuum: constant acceleration.
#pragma once
#include <Eigen/Core>

#include "scenes/state.h"

namespace scenes {

/// A cannonball in a vacuum, shot from the origin: x'' = (0, -g). The ground is not modelled.
/// @tparam Real  `double` or `float`
/// @see G. Galilei, Discorsi e dimostrazioni matematiche intorno a due nuove scienze (1638), day 4
template <class Real = double>
struct Projectile {
  using Vec = Eigen::Matrix<Real, 2, 1>;  ///< a point of the plane: right, up

  Vec start_velocity{Real(10), Real(10)};  ///< [m/s]
  Real g = Real(9.81);                     ///< acceleration of gravity, downwards [m/s^2]

  /// The acceleration of gravity [m/s^2], the same everywhere and always.
  template <class Time>
  Vec operator()(const Vec&, const Vec&, Time) const {
    return {Real(0), -g};
  }

  /// At the origin, with the start velocity.
  State<Vec> start() const { return {Vec::Zero(), start_velocity}; }

  /// The state at any time, also before the start.
  /// @param t  time since the start [s]
  State<Vec> exact(Real t) const {
    const Vec a{Real(0), -g};
    return {t * start_velocity + (t * t / Real(2)) * a, start_velocity + t * a};
  }

  /// Energy per unit mass, which is conserved [J/kg].
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  Real energy(const Vec& x, const Vec& v) const { return v.squaredNorm() / Real(2) + g * x.y(); }
};

}  // namespace scenes
