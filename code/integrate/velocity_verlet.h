// SPDX-License-Identifier: MIT-0
/// @file
/// Velocity Verlet: kick, drift, kick.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// double a = integrate::velocity_verlet_start(x, v, 0.0, spring);
/// for (int n = 0; n < 60; ++n) integrate::velocity_verlet(x, v, a, n * h, h, spring);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

/// The acceleration at the start, for velocity_verlet to begin with.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Position, class Vec, class Time, class Acceleration>
constexpr Vec velocity_verlet_start(const Position& x, const Vec& v, Time t,
                                    Acceleration&& acceleration) {
  constexpr bool calls =
      std::is_invocable_r_v<Vec, Acceleration&, const Position&, const Vec&, Time>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  if constexpr (calls) return acceleration(x, v, t);
}

/// One step of velocity Verlet: half a kick, a drift, half a kick with the new acceleration.
///
/// Order 2, one evaluation of the acceleration, stable on drag while c*h < 1, on an undamped spring
/// while h*omega < 2. Drag sees a predicted velocity at the end of the step: that keeps order 2,
/// and halves the limit on drag. On poses, order 2.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param a  acceleration at the start, replaced by the one at the end; see velocity_verlet_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see Swope, Andersen, Berens and Wilson, Journal of Chemical Physics 76 (1982)
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void velocity_verlet(Position& x, Vec& v, Vec& a, Time t, Real h,
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
    // [move]
    const Vec v_half = v + (h / Real(2)) * a;
    const Vec v_predicted = v + h * a;
    x = x + h * v_half;
    a = acceleration(x, v_predicted, t_end);
    v = v_half + (h / Real(2)) * a;
    // [move]
  }
}

}  // namespace integrate
