// SPDX-License-Identifier: MIT-0
/// @file
/// A mass on a spring, damped or not.
#pragma once
#include <cmath>

#include "scenes/state.h"

namespace scenes {

/// A mass on a spring: x'' = -omega^2 x - 2 zeta omega x'.
/// @tparam Real  `double` or `float`
/// @see L. D. Landau and E. M. Lifshitz, Mechanics (1976), section 25
template <class Real = double>
struct Spring {
  using Vec = Real;  ///< how far the spring is stretched [m]

  Real omega = 1;  ///< natural frequency [rad/s]; not zero
  Real zeta = 0;   ///< damping ratio; 0 swings for ever, from 1 on it does not swing; not negative
  Real x0 = 1;     ///< position at the start [m]
  Real v0 = 0;     ///< velocity at the start [m/s]

  // [acceleration]
  /// The acceleration [m/s^2], in any number of dimensions.
  /// @tparam V  a number or a vector
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  template <class V, class Time>
  constexpr V operator()(const V& x, const V& v, Time) const {
    return (-omega * omega) * x + (Real(-2) * zeta * omega) * v;
  }
  // [acceleration]

  /// Hands the derivatives of the acceleration on, for the implicit methods.
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class V, class Time, class Add>
  constexpr void jacobian(const V&, const V&, Time, Add&& add) const {
    add(0, 0, -omega * omega, -damping());
  }

  /// Damping per mass, 2 zeta omega [1/s].
  constexpr Real damping() const { return Real(2) * zeta * omega; }

  /// The start.
  constexpr State<Vec> start() const { return {x0, v0}; }

  /// The state at any time, also before the start.
  /// @param t  time since the start [s]
  State<Vec> exact(Real t) const { return zeta < Real(1) ? swinging(t) : creeping(t); }

  /// Energy per unit mass [J/kg]; conserved without damping, and never growing with it.
  /// @param x  position [m]
  /// @param v  velocity [m/s]
  constexpr Real energy(const Vec& x, const Vec& v) const {
    return (v * v + omega * omega * x * x) / Real(2);
  }

 private:
  State<Vec> swinging(Real t) const {
    const Real decay = zeta * omega;
    const Real damped = omega * std::sqrt((Real(1) - zeta) * (Real(1) + zeta));
    const Real cosine = std::cos(damped * t);
    const Real sine = std::sin(damped * t) / damped;
    const Real left = std::exp(-decay * t);
    return {left * (x0 * (cosine + decay * sine) + v0 * sine),
            left * (v0 * (cosine - decay * sine) - omega * omega * x0 * sine)};
  }

  // The sum of two exponentials, of rates `slow` and `fast`, written so that nothing is lost when
  // the two rates meet.
  State<Vec> creeping(Real t) const {
    const Real apart = omega * std::sqrt((zeta - Real(1)) * (zeta + Real(1)));
    const Real fast = zeta * omega + apart;
    const Real slow = omega * omega / fast;
    const Real ramp = apart == 0 ? t : -std::expm1(Real(-2) * apart * t) / (Real(2) * apart);
    const Real push = slow * x0 + v0;
    const Real left = std::exp(-slow * t);
    return {left * (x0 + push * ramp), left * (v0 - fast * push * ramp)};
  }
};

}  // namespace scenes
