// SPDX-License-Identifier: MIT-0
/// @file
/// A leaf that falls through air: drag in proportion to the speed.
#pragma once
#include <cmath>

#include "scenes/state.h"

namespace scenes {

/// A fall through air that resists in proportion to the speed: x'' = -g - c x'.
/// @tparam Real  `double` or `float`
/// @see I. Newton, Philosophiae naturalis principia mathematica (1687), book II, section 1
template <class Real = double>
struct LinearDrag {
  using Vec = Real;  ///< height [m], up

  Real c = 1;           ///< drag coefficient per mass [1/s]; zero is a fall in a vacuum
  Real g = Real(9.81);  ///< acceleration of gravity, downwards [m/s^2]; zero leaves drag alone
  Real v0 = 0;          ///< velocity at the start, upwards [m/s]

  /// The acceleration [m/s^2].
  /// @param v  velocity [m/s]
  template <class Time>
  constexpr Vec operator()(const Vec&, const Vec& v, Time) const {
    return -g - c * v;
  }

  /// Hands the derivatives of the acceleration on, for the implicit methods.
  /// @param add  called as `add(i, j, dadx, dadv)`: row, column, by position [1/s^2], by velocity
  /// [1/s]
  template <class V, class Time, class Add>
  constexpr void jacobian(const V&, const V&, Time, Add&& add) const {
    add(0, 0, Real(0), -c);
  }

  /// Damping per mass [1/s].
  constexpr Real damping() const { return c; }

  /// At height zero, with the start velocity.
  constexpr State<Vec> start() const { return {Real(0), v0}; }

  /// The state at any time, also before the start and without drag.
  /// @param t  time since the start [s]
  State<Vec> exact(Real t) const {
    const Real z = -c * t;
    const Real phi1 = z == 0 ? Real(1) : std::expm1(z) / z;
    return {v0 * t * phi1 - g * t * t * phi2(z), v0 * std::exp(z) - g * t * phi1};
  }

  /// The speed at which the fall ends, where drag and gravity are in balance [m/s].
  constexpr Real terminal_speed() const { return g / c; }

 private:
  /// (e^z - 1 - z) / z^2, by its series near zero, where the formula cancels.
  static Real phi2(Real z) {
    if (std::abs(z) > Real(0.5)) return (std::expm1(z) - z) / (z * z);
    Real sum = 0;
    for (int n = 16; n >= 2; --n) sum = (Real(1) + z * sum) / Real(n);
    return sum;
  }
};

}  // namespace scenes
