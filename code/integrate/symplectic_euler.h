// SPDX-License-Identifier: MIT-0
/// @file
/// Symplectic Euler: velocity first, then position; and its twin, position first.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::symplectic_euler(x, v, n / 60.0, 1 / 60.0, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of symplectic Euler: velocity first, then position with the new velocity.
///
/// Order 1, one evaluation of the acceleration, stable on drag while c*h < 2, on an undamped spring
/// while h*omega < 2. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.1.2
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void symplectic_euler(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
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
    v = v + h * a;
    x = x + h * v;
    // [move]
  }
}

/// One step of symplectic Euler the other way round: position first, then velocity with the
/// acceleration at the new position.
///
/// Order 1, one evaluation of the acceleration, stable on drag while c*h < 2, on an undamped spring
/// while h*omega < 2. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section I.1.2
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void symplectic_euler_position_first(Position& x, Vec& v, Time t, Real h,
                                               Acceleration&& acceleration) {
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
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_end = Clock(t) + Clock(h);
    // [position-first-move]
    x = x + h * v;
    const Vec a = acceleration(x, v, t_end);
    v = v + h * a;
    // [position-first-move]
  }
}

}  // namespace integrate
