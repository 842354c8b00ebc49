// SPDX-License-Identifier: MIT-0
/// @file
/// A puck that slides to a halt: dry friction.
#pragma once
#include <algorithm>
#include <cmath>

#include "scenes/state.h"

namespace scenes {

/// A puck on a table, with dry friction: x'' = -mu g sign(x').
///
/// The sign of zero is zero: a puck at rest stays at rest. The acceleration jumps there, and a step
/// rarely ends at rest exactly. A method that does nothing about it never stops: it chatters, to
/// and fro, at speeds up to mu g h.
/// @tparam Real  `double` or `float`
/// @see C. A. Coulomb, Théorie des machines simples (1785)
template <class Real = double>
struct Friction {
  using Vec = Real;  ///< position along the table [m]

  Real mu = Real(0.1);  ///< coefficient of friction; not negative
  Real g = Real(9.81);  ///< acceleration of gravity [m/s^2]
  Real v0 = 2;          ///< velocity at the start [m/s]

  /// The acceleration [m/s^2].
  /// @param v  velocity [m/s]
  template <class Time>
  constexpr Vec operator()(const Vec&, const Vec& v, Time) const {
    if (v == Real(0)) return Real(0);
    return v > Real(0) ? -mu * g : mu * g;
  }

  /// At position zero, with the start velocity.
  constexpr State<Vec> start() const { return {Real(0), v0}; }

  /// When the puck comes to rest [s]. Needs mu * g > 0.
  constexpr Real stopping_time() const { return (v0 < 0 ? -v0 : v0) / (mu * g); }

  /// The state, sliding or at rest.
  /// @param t  time since the start [s]; before the start, the puck slid as well
  State<Vec> exact(Real t) const {
    const Real sliding = std::min(t, stopping_time());
    const Real v = v0 - std::copysign(mu * g, v0) * sliding;
    return {(v0 + v) / Real(2) * sliding, t < stopping_time() ? v : Real(0)};
  }
};

}  // namespace scenes
