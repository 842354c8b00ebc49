// SPDX-License-Identifier: MIT-0
/// @file
/// Backward Euler, or implicit Euler, on a damped spring, solved by hand.
///
/// @code
/// double x = 1, v = 0;
/// const double omega = 3, zeta = 1 / 6.0;
/// for (int n = 0; n < 60; ++n) integrate::backward_euler_spring(x, v, 1 / 60.0, omega, zeta);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of backward (implicit) Euler on a damped spring.
///
/// Order 1, no evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// for every h. The spring is `x'' = -omega^2 x - 2 zeta omega x'`.
///
/// @param x  position from where the spring is at rest, advanced in place
/// @param v  velocity, advanced in place
/// @param h  step size [s]; a negative step goes back in time, but from zeta = 1 on only while
/// |h|*omega < zeta - sqrt(zeta^2 - 1), where it divides by zero
/// @param omega  natural frequency [rad/s]; not negative
/// @param zeta  damping ratio; 0 swings for ever; at 1 it overshoots only if it comes in faster
/// than omega*|x|, above 1 only if faster still; not negative
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.3
template <class Vec, class Real>
constexpr void backward_euler_spring(Vec& x, Vec& v, Real h, Real omega, Real zeta) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h, omega and zeta must be no integers");
  if constexpr (scales) {
    // [move]
    const Real angle = h * omega;
    const Real left = Real(1) / (Real(1) + Real(2) * zeta * angle + angle * angle);
    v = left * Vec(v + (-angle * omega) * x);
    x = x + h * v;
    // [move]
  }
}

}  // namespace integrate
