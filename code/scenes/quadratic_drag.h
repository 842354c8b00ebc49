// SPDX-License-Identifier: MIT-0
/// @file
/// A skydiver or a thrown ball: drag in proportion to the square of the speed.
#pragma once
#include <cmath>
#include <numbers>
#include <type_traits>

#include "scenes/state.h"

namespace scenes {

/// A fall through air that resists with the square of the speed: x'' = -g - k |x'| x'.
///
/// The same scene is a ball thrown in the plane or in space: with Eigen vectors, gravity pulls
/// against the second coordinate.
/// @tparam Real  `double` or `float`
/// @see I. Newton, Philosophiae naturalis principia mathematica (1687), book II, section 2
template <class Real = double>
struct QuadraticDrag {
  using Vec = Real;  ///< height [m], up

  Real k = Real(0.004);  ///< drag coefficient per mass [1/m]; not negative
  Real g = Real(9.81);   ///< acceleration of gravity, downwards [m/s^2]

  /// The acceleration [m/s^2].
  /// @tparam V  a number, or an Eigen vector of two or three coordinates
  /// @param v  velocity [m/s]
  template <class V, class Time>
  constexpr V operator()(const V&, const V& v, Time) const {
    if constexpr (std::is_floating_point_v<V>) {
      return -g - k * (v < 0 ? -v : v) * v;
    } else {
      V a = (-k * v.norm()) * v;
      a.y() -= g;
      return a;
    }
  }

  /// At rest, at height zero.
  constexpr State<Vec> start() const { return {Real(0), Real(0)}; }

  /// The state of the fall from rest.
  /// @param t  time since the start [s]; not negative. Needs g > 0 and k > 0.
  State<Vec> exact(Real t) const {
    const Real s = t * std::sqrt(g * k);
    return {-log_cosh(s) / k, -terminal_speed() * std::tanh(s)};
  }

  /// The speed at which the fall ends, where drag and gravity are in balance [m/s].
  Real terminal_speed() const { return std::sqrt(g / k); }

 private:
  /// log(cosh(s)) for s >= 0: cosh itself overflows for large s, and cancels for small s.
  static Real log_cosh(Real s) {
    if (s > Real(1)) return s - std::numbers::ln2_v<Real> + std::log1p(std::exp(Real(-2) * s));
    const Real half = std::sinh(s / Real(2));
    return std::log1p(Real(2) * half * half);
  }
};

}  // namespace scenes
