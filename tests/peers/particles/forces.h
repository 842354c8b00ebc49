// SPDX-License-Identifier: MIT-0
#pragma once

namespace particles {

/// What pulls on one coordinate of every particle, per unit mass: a spring, gravity and drag.
template <class Real>
struct Forces {
  Real gravity;              ///< [m/s^2]
  Real stiffness = Real(4);  ///< [1/s^2]
  Real drag = Real(0.1);     ///< [1/s]

  /// The acceleration of one number, or of a block of them.
  template <class Vec>
  Vec operator()(const Vec& x, const Vec& v, Real) const {
    return gravity - stiffness * x - drag * v;
  }
};

/// Gravity along each axis [m/s^2].
constexpr double gravity[3] = {0, -9.81, 0};

}  // namespace particles
