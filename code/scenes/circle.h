// SPDX-License-Identifier: MIT-0
/// @file
/// The circle of the talks: a body that should go round for ever.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "scenes/state.h"

namespace scenes {

/// A body on a circle around the origin, pulled inwards in proportion to the distance:
/// x'' = -omega^2 x in the plane.
/// @tparam Real  `double` or `float`
/// @see J. M. Van Verth, Numerical Integration, Essential Math for Games Programmers
template <class Real = double>
struct Circle {
  using Vec = Eigen::Matrix<Real, 2, 1>;  ///< a point of the plane

  Real omega = 1;   ///< angular frequency [rad/s]; not zero
  Real radius = 1;  ///< [m]

  /// The acceleration [m/s^2], in any number of dimensions.
  /// @tparam V  a number or a vector
  /// @param x  position [m]
  template <class V, class Time>
  constexpr V operator()(const V& x, const V&, Time) const {
    return (-omega * omega) * x;
  }

  /// Hands the derivatives of the acceleration on, for the implicit methods.
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class V, class Time, class Add>
  constexpr void jacobian(const V&, const V&, Time, Add&& add) const {
    add(0, 0, -omega * omega, Real(0));
    add(1, 1, -omega * omega, Real(0));
  }

  /// On the first axis, on its way to the second.
  State<Vec> start() const { return {Vec{radius, Real(0)}, Vec{Real(0), radius * omega}}; }

  /// The state at any time, also before the start.
  /// @param t  time since the start [s]
  State<Vec> exact(Real t) const {
    const Vec direction{std::cos(omega * t), std::sin(omega * t)};
    const Vec forward{-direction.y(), direction.x()};
    return {radius * direction, (radius * omega) * forward};
  }

  /// Time of one turn [s].
  constexpr Real period() const { return Real(2) * std::numbers::pi_v<Real> / omega; }

  /// Energy per unit mass, which is conserved [J/kg].
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  Real energy(const Vec& x, const Vec& v) const {
    return (v.squaredNorm() + omega * omega * x.squaredNorm()) / Real(2);
  }

  /// Angular momentum per unit mass, which is conserved [m^2/s].
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  Real angular_momentum(const Vec& x, const Vec& v) const { return x.x() * v.y() - x.y() * v.x(); }
};

}  // namespace scenes
