// SPDX-License-Identifier: MIT-0
/// @file
/// A weight on a rod, swinging as far as it likes.
#pragma once
#include <cmath>
#include <numbers>

#include "scenes/sine.h"
#include "scenes/state.h"

namespace scenes {

/// A weight on a rod without mass: x'' = -(g / length) sin x, where x is an angle.
///
/// The sine is the book's own, so that a trajectory has the same bits on every machine.
/// @tparam Real  `double` or `float`
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.1.3
template <class Real = double>
struct Pendulum {
  using Vec = Real;  ///< angle from hanging straight down [rad]; at most 1e5, see sine()

  Real g = Real(9.81);  ///< acceleration of gravity [m/s^2]
  Real length = 1;      ///< of the rod [m]
  Real angle = 1;       ///< angle at the start [rad]

  /// The angular acceleration [rad/s^2].
  /// @param x  angle [rad]
  template <class Time>
  constexpr Vec operator()(const Vec& x, const Vec&, Time) const {
    return (-g / length) * sine(x);
  }

  /// Hands the derivatives of the acceleration on, for the implicit methods.
  /// @param x  angle [rad]
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class Time, class Add>
  constexpr void jacobian(const Vec& x, const Vec&, Time, Add&& add) const {
    add(0, 0, (-g / length) * cosine(x), Real(0));
  }

  /// At rest, at the start angle.
  constexpr State<Vec> start() const { return {angle, Real(0)}; }

  /// Energy per unit mass, which is conserved; zero when hanging at rest [J/kg].
  /// @param x  angle [rad]
  /// @param v  angular velocity [rad/s]
  constexpr Real energy(const Vec& x, const Vec& v) const {
    const Real speed = length * v;
    const Real half = sine(x / Real(2));
    return speed * speed / Real(2) + Real(2) * g * length * half * half;
  }

  /// Time of one full swing from the start and back [s], by the arithmetic-geometric mean.
  ///
  /// Needs a start angle between -pi and pi.
  /// @see NIST Digital Library of Mathematical Functions, section 19.8(i)
  Real period() const {
    Real arithmetic = 1;
    Real geometric = cosine(angle / Real(2));
    for (;;) {
      const Real mean = (arithmetic + geometric) / Real(2);
      if (!(mean < arithmetic)) break;
      geometric = std::sqrt(arithmetic * geometric);
      arithmetic = mean;
    }
    return Real(2) * std::numbers::pi_v<Real> * std::sqrt(length / g) / arithmetic;
  }
};

}  // namespace scenes
