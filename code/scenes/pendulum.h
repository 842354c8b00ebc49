// SPDX-License-Identifier: MIT-0
/// @file
/// A weight on a rod, swinging as far as it likes.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
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

  /// The state at any time, also before the start; a start near pi costs digits.
  ///
  /// Needs a start angle between -pi and pi.
  /// @param t  time since the start [s]
  /// @see NIST Digital Library of Mathematical Functions, section 22.20(ii)
  State<Vec> exact(Real t) const {
    const Real modulus = std::sin(angle / Real(2));
    const Real phase = amplitude(std::remainder(t, period()));
    const Real rate = std::sqrt(g / length);
    return {Real(2) * std::asin(modulus * std::sin(phase)),
            Real(2) * modulus * rate * std::cos(phase)};
  }

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

 private:
  // Jacobi's amplitude a quarter of a swing ahead, where the pendulum is at rest: up the means
  // until they meet, and down again by Landen's transformation.
  Real amplitude(Real t) const {
    constexpr int most = 16;
    std::array<Real, most> ratio{};
    Real arithmetic = 1;
    Real geometric = std::cos(angle / Real(2));
    int n = 0;
    while (n < most && geometric < arithmetic) {
      const Real mean = (arithmetic + geometric) / Real(2);
      ratio[std::size_t(n++)] = (arithmetic - geometric) / (Real(2) * mean);
      geometric = std::sqrt(arithmetic * geometric);
      arithmetic = mean;
    }
    const Real quarter = std::numbers::pi_v<Real> / Real(2);
    Real phase = std::ldexp(quarter + arithmetic * std::sqrt(g / length) * t, n);
    while (n > 0) phase = (phase + std::asin(ratio[std::size_t(--n)] * std::sin(phase))) / Real(2);
    return phase;
  }
};

}  // namespace scenes
