// SPDX-License-Identifier: MIT-0
/// @file
/// Euler's method: along the tangent.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::euler(x, v, n / 60.0, 1 / 60.0, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

// [signature]
/// One step of Euler's method: position and velocity both move along the tangent at the start.
///
/// Order 1, one evaluation of the acceleration, stable on drag while c*h < 2, on a damped spring
/// while h*omega < 2*zeta (zeta <= 1) or 2*(zeta - sqrt(zeta^2 - 1)) (zeta >= 1), never on an
/// undamped spring. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see L. Euler, Institutionum calculi integralis, volume 1 (1768), chapter 7
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void euler(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
  // [signature]
  constexpr bool calls =
      std::is_invocable_r_v<Vec, Acceleration&, const Position&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr auto add = [](const auto& y, const auto& z) -> decltype(y + z) { return y + z; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool moves = std::is_invocable_r_v<Position, decltype(add), Position, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(moves, "x + h * v must be a Position, which is the type of x");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (calls && scales && moves) {
    // [move]
    const Vec a = acceleration(x, v, t);
    x = x + h * v;
    v = v + h * a;
    // [move]
  }
}

}  // namespace integrate
