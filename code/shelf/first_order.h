// SPDX-License-Identifier: MIT-0
/// @file
/// Steps for what has a velocity at every place and no inertia, x' = u(x, t): smoke in wind, leaves
/// on a river, a boid that steers, a particle that follows a field.
///
/// @code
/// #include <complex>
///
/// // Smoke round a chimney, in a wind that goes once round in 2 pi seconds.
/// const auto wind = [](std::complex<double> place, double) {
///   return std::complex<double>(-place.imag(), place.real());
/// };
/// std::complex<double> euler = 1, midpoint = 1, rk4 = 1;
/// const double h = 1 / 10.0;
/// for (int n = 0; n < 100; ++n) {
///   shelf::first_order_euler(euler, n * h, h, wind);
///   shelf::first_order_midpoint(midpoint, n * h, h, wind);
///   shelf::first_order_rk4(rk4, n * h, h, wind);
/// }
/// // Now std::abs(euler) is 1.6446.
/// // Now std::abs(midpoint) is 1.0013.
/// // Now std::abs(rk4) is 1.0000.
/// @endcode
///
/// Towards a wind that drags, `u = c (wind - x)`, Euler and midpoint stay bounded while c h < 2,
/// RK4 while c h < 2.785; smooth_damp.h has `smooth`, which has no limit there.
///
/// Promises:
/// - Euler has order 1, midpoint order 2 and RK4 order 4, all to 0.05, in a wind that depends on
///   place and time
/// - in a step Euler asks for u once, midpoint twice and RK4 four times
/// - round a vortex, for omega h from 0.1 to 1, Euler flings smoke out by the factor
///   sqrt(1 + (omega h)^2) in every step; midpoint by less than 1 + (omega h)^4 / 8, and RK4 draws
///   it in by less than (omega h)^6 / 144
/// - in ten rounds of the hares and foxes of Lotka and Volterra, from (2, 1) at a hundred steps a
///   round, RK4 keeps their invariant to 1e-6, midpoint to 2e-3, and Euler loses it by more than 1
/// - a step and the way back, with -h, miss the start by an error of order 2 with Euler, 4 with
///   midpoint and 6 with RK4, all to 0.1
#pragma once
#include <type_traits>

namespace shelf {

/// One step of Euler's method for x' = u(x, t): straight on with the velocity of the start.
///
/// Order 1, one evaluation of u. In a vortex it spirals out at any step. Calls nothing of the C
/// library.
///
/// @param x  place, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param u  velocity at a place and a time, callable `(x, t) -> Vec` [units of x per s]
/// @see L. Euler, Institutiones calculi integralis (1768), section 650
template <class Vec, class Time, class Real, class Velocity>
constexpr void first_order_euler(Vec& x, Time t, Real h, Velocity&& u) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Velocity&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "u must be callable as Vec(x, t)");
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (calls && scales) {
    // [euler]
    const Vec u1 = u(x, t);
    x = x + h * u1;
    // [euler]
  }
}

/// One step of the midpoint method for x' = u(x, t): half a step of Euler's shows the velocity for
/// the whole step.
///
/// Order 2, two evaluations of u. What advects smoke takes it, as a rule. Calls nothing of the C
/// library.
///
/// @param x  place, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param u  velocity at a place and a time, callable `(x, t) -> Vec` [units of x per s]
/// @see C. Runge, Ueber die numerische Aufloesung von Differentialgleichungen (1895)
template <class Vec, class Time, class Real, class Velocity>
constexpr void first_order_midpoint(Vec& x, Time t, Real h, Velocity&& u) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Velocity&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "u must be callable as Vec(x, t)");
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (calls && scales) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_middle = Clock(t) + Clock(h / Real(2));
    // [midpoint]
    const Real half = h / Real(2);
    const Vec u1 = u(x, t);
    const Vec u2 = u(Vec(x + half * u1), t_middle);
    x = x + h * u2;
    // [midpoint]
  }
}

/// One step of the classical Runge-Kutta method for x' = u(x, t).
///
/// Order 4, four evaluations of u. Calls nothing of the C library.
///
/// @param x  place, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param u  velocity at a place and a time, callable `(x, t) -> Vec` [units of x per s]
/// @see W. Kutta, Beitrag zur naeherungsweisen Integration totaler Differentialgleichungen (1901)
template <class Vec, class Time, class Real, class Velocity>
constexpr void first_order_rk4(Vec& x, Time t, Real h, Velocity&& u) {
  constexpr bool calls = std::is_invocable_r_v<Vec, Velocity&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "u must be callable as Vec(x, t)");
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (calls && scales) {
    using Clock = std::common_type_t<Time, Real>;  // for -Wdouble-promotion
    const Clock t_middle = Clock(t) + Clock(h / Real(2));
    const Clock t_end = Clock(t) + Clock(h);
    // [rk4]
    const Real half = h / Real(2);
    const Vec u1 = u(x, t);
    const Vec u2 = u(Vec(x + half * u1), t_middle);
    const Vec u3 = u(Vec(x + half * u2), t_middle);
    const Vec u4 = u(Vec(x + h * u3), t_end);
    x = x + (h / Real(6)) * (u1 + Real(2) * (u2 + u3) + u4);
    // [rk4]
  }
}

}  // namespace shelf
