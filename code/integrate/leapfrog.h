// SPDX-License-Identifier: MIT-0
/// @file
/// Leapfrog: velocities at half steps.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// double v_half = integrate::leapfrog_start(x, v, 0.0, h, spring);
/// for (int n = 0; n < 60; ++n) integrate::leapfrog(x, v_half, n * h, h, spring);
/// v = integrate::leapfrog_velocity(x, v_half, 60 * h, h, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

// Checks that leapfrog can use these types; what one lacks is a compile error that says so.
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr bool leapfrog_accepts() {
  constexpr bool calls =
      std::is_invocable_r_v<Vec, Acceleration&, const Position&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr auto add = [](const auto& y, const auto& z) -> decltype(y + z) { return y + z; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool moves = std::is_invocable_r_v<Position, decltype(add), Position, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(!calls || scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(moves, "x + h * v must be a Position, which is the type of x");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  return calls && scales && moves;
}

/// The velocity half a step before the start, for leapfrog to begin with.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr Vec leapfrog_start(const Position& x, const Vec& v, Time t, Real h,
                             Acceleration&& acceleration) {
  if constexpr (leapfrog_accepts<Position, Vec, Time, Real, Acceleration>())
    return v + (h / Real(-2)) * acceleration(x, v, t);
}

/// The velocity at the time of the position; costs an evaluation of the acceleration.
///
/// @param x  position
/// @param v_half  velocity half a step ago
/// @param t  time of `x` [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr Vec leapfrog_velocity(const Position& x, const Vec& v_half, Time t, Real h,
                                Acceleration&& acceleration) {
  if constexpr (leapfrog_accepts<Position, Vec, Time, Real, Acceleration>())
    return v_half + (h / Real(2)) * acceleration(x, v_half, t);
}

/// One step of leapfrog: the velocities live half a step before and after the positions.
///
/// Order 2, 1 under drag, one evaluation of the acceleration, stable on drag while c*h < 2, on an
/// undamped spring while h*omega < 2. The arithmetic is that of symplectic Euler; the start, half a
/// step back, is what makes it order 2. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v_half  velocity half a step before `x`, advanced in place; see leapfrog_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see Hairer, Lubich and Wanner, Geometric numerical integration illustrated by the
/// Stormer-Verlet method, Acta Numerica 12 (2003)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void leapfrog(Position& x, Vec& v_half, Time t, Real h, Acceleration&& acceleration) {
  if constexpr (leapfrog_accepts<Position, Vec, Time, Real, Acceleration>()) {
    // [move]
    const Vec a = acceleration(x, v_half, t);
    v_half = v_half + h * a;
    x = x + h * v_half;
    // [move]
  }
}

}  // namespace integrate
