// SPDX-License-Identifier: MIT-0
/// @file
/// Drift, kick, drift: leapfrog that begins and ends with half a step of the position, and keeps
/// nothing but position and velocity.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) integrate::leapfrog_drift(x, v, n / 60.0, 1 / 60.0, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// One step of drift, kick, drift: half the way with the velocity of now, the whole kick by the
/// acceleration at the middle, and the other half of the way with the new velocity.
///
/// Order 2, 1 under drag, one evaluation of the acceleration, stable on drag while c*h < 2, on an
/// undamped spring while h*omega < 2. Nothing is carried from one step to the next: between two
/// steps, `x` and `v` may be set to anything. Drag is asked with the velocity of the start of the
/// step, which costs it an order; velocity_verlet.h keeps order 2 there. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]; called with the position
/// and the time of the middle of the step
/// @see Hairer, Lubich and Wanner, Geometric numerical integration illustrated by the
/// Stormer-Verlet method, Acta Numerica 12 (2003)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void leapfrog_drift(Position& x, Vec& v, Time t, Real h, Acceleration&& acceleration) {
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
    const Clock t_middle = Clock(t) + Clock(h / Real(2));
    // [move]
    x = x + (h / Real(2)) * v;
    const Vec a = acceleration(x, v, t_middle);
    v = v + h * a;
    x = x + (h / Real(2)) * v;
    // [move]
  }
}

}  // namespace integrate
