// SPDX-License-Identifier: MIT-0
/// @file
/// Position Verlet, or Stormer-Verlet: the next position from the last two.
///
/// @code
/// const auto spring = [](double x, double v, double) { return -9 * x - v; };
/// const double h = 1 / 60.0;
/// double x = 1, v = 0;
/// double x_previous = integrate::stormer_verlet_start(x, v, 0.0, h, spring);
/// for (int n = 0; n < 60; ++n) integrate::stormer_verlet(x, x_previous, n * h, h, spring);
/// v = integrate::stormer_verlet_velocity(x, x_previous, h);
/// @endcode
///
/// Carrying the acceleration, from the same start:
/// @code
/// x = 1, v = 0;
/// double a = spring(x, v, 0.0);
/// x_previous = integrate::stormer_verlet_start(x, v, 0.0, h, spring);
/// for (int n = 0; n < 60; ++n) {
///   integrate::stormer_verlet_carried(x, x_previous, a, n * h, h, spring);
/// }
/// v = integrate::stormer_verlet_carried_velocity(x, x_previous, a, h);
/// @endcode
///
/// Keeping the last distance in place of the last position, for places in float:
/// @code
/// x = 1, v = 0;
/// double distance = integrate::stormer_verlet_distance_start(x, v, 0.0, h, spring);
/// for (int n = 0; n < 60; ++n) {
///   integrate::stormer_verlet_distance(x, distance, n * h, h, spring);
/// }
/// v = distance / h;
/// @endcode
///
/// With steps as long as the frames are:
/// @code
/// x = 1, v = 0;
/// double t = 0, h_previous = h;
/// x_previous = integrate::stormer_verlet_start(x, v, t, h_previous, spring);
/// for (int n = 0; n < 40; ++n) {
///   const double frame = n % 2 == 0 ? 0.01 : 0.04;
///   integrate::stormer_verlet_uneven(x, x_previous, t, frame, h_previous, spring);
///   t = t + frame;
///   h_previous = frame;
/// }
/// v = integrate::stormer_verlet_velocity(x, x_previous, h_previous);
/// @endcode
#pragma once
#include <type_traits>

namespace integrate {

// Checks that position Verlet can use these types; what one lacks is a compile error that says so.
template <class Vec, class Time, class Real, class Acceleration>
constexpr bool stormer_verlet_accepts() {
  constexpr bool calls = std::is_invocable_r_v<Vec, Acceleration&, const Vec&, const Vec&, Time>;
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(calls, "acceleration must be callable as Vec(x, v, t)");
  static_assert(!calls || scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  return calls && scales;
}

/// The velocity of position Verlet: the last step's distance over its time.
///
/// Order 1: it is the velocity of half a step ago.
///
/// @param x  position
/// @param x_previous  position one step ago
/// @param h  step size [s]
template <class Vec, class Real>
constexpr Vec stormer_verlet_velocity(const Vec& x, const Vec& x_previous, Real h) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales) {
    // [velocity-move]
    return (Real(1) / h) * (x + Real(-1) * x_previous);
    // [velocity-move]
  }
}

/// The velocity of position Verlet, brought from half a step ago to now by the last acceleration.
///
/// Order 2.
///
/// @param x  position
/// @param x_previous  position one step ago
/// @param a  acceleration one step ago [units of x per s^2]
/// @param h  step size [s]
template <class Vec, class Real>
constexpr Vec stormer_verlet_carried_velocity(const Vec& x, const Vec& x_previous, const Vec& a,
                                              Real h) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales) return (Real(1) / h) * (x + Real(-1) * x_previous) + (h / Real(2)) * a;
}

/// The position one step before the start, for stormer_verlet and its variants to begin with.
///
/// Right to h^3, as order 2 needs. With `x_previous = x` the order would be 1 from rest, else 0.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Real, class Acceleration>
constexpr Vec stormer_verlet_start(const Vec& x, const Vec& v, Time t, Real h,
                                   Acceleration&& acceleration) {
  if constexpr (stormer_verlet_accepts<Vec, Time, Real, Acceleration>()) {
    // [start-move]
    return x + Real(-1) * h * v + (h * h / Real(2)) * acceleration(x, v, t);
    // [start-move]
  }
}

/// One step of position Verlet (Stormer-Verlet); drag sees the last step's distance over its time.
///
/// Order 2 in position, 1 in velocity and under drag, one evaluation of the acceleration, stable on
/// drag while c*h < 2, on an undamped spring while h*omega < 2. The step must stay the same from
/// start to end; for one that changes there is stormer_verlet_uneven.
///
/// @param x  position, advanced in place
/// @param x_previous  position one step ago, advanced in place; see stormer_verlet_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see L. Verlet, Computer "experiments" on classical fluids, Physical Review 159 (1967)
template <class Vec, class Time, class Real, class Acceleration>
constexpr void stormer_verlet(Vec& x, Vec& x_previous, Time t, Real h,
                              Acceleration&& acceleration) {
  if constexpr (stormer_verlet_accepts<Vec, Time, Real, Acceleration>()) {
    // [move]
    const Vec v = stormer_verlet_velocity(x, x_previous, h);
    const Vec a = acceleration(x, v, t);
    const Vec x_next = Real(2) * x + Real(-1) * x_previous + (h * h) * a;
    x_previous = x;
    x = x_next;
    // [move]
  }
}

/// One step of position Verlet that carries the acceleration, so that drag sees a velocity of now.
///
/// Order 2, one evaluation of the acceleration, stable on drag while c*h < 1, on an undamped spring
/// while h*omega < 2. The step must stay the same from start to end.
///
/// @param x  position, advanced in place
/// @param x_previous  position one step ago, advanced in place; see stormer_verlet_start
/// @param a  acceleration one step ago, for the first step that of the start; replaced by the one
/// at `x` [units of x per s^2]
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Real, class Acceleration>
constexpr void stormer_verlet_carried(Vec& x, Vec& x_previous, Vec& a, Time t, Real h,
                                      Acceleration&& acceleration) {
  if constexpr (stormer_verlet_accepts<Vec, Time, Real, Acceleration>()) {
    // [carried-move]
    const Vec v = stormer_verlet_carried_velocity(x, x_previous, a, h);
    a = acceleration(x, v, t);
    const Vec x_next = Real(2) * x + Real(-1) * x_previous + (h * h) * a;
    x_previous = x;
    x = x_next;
    // [carried-move]
  }
}

/// The distance of the step before the start, for stormer_verlet_distance to begin with.
///
/// Right to h^3, as order 2 needs.
///
/// @param x  position
/// @param v  velocity
/// @param t  time of `x` and `v` [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Real, class Acceleration>
constexpr Vec stormer_verlet_distance_start(const Vec& x, const Vec& v, Time t, Real h,
                                            Acceleration&& acceleration) {
  if constexpr (stormer_verlet_accepts<Vec, Time, Real, Acceleration>()) {
    return h * v + (Real(-1) * h * h / Real(2)) * acceleration(x, v, t);
  }
}

/// One step of position Verlet that keeps the last distance in place of the last position.
///
/// Order 2 in position, 1 in velocity and under drag, one evaluation of the acceleration, stable on
/// drag while c*h < 2, on an undamped spring while h*omega < 2. The path is stormer_verlet's but
/// for rounding: two rounded positions make a rounded distance that every later step repeats, and
/// here there is only one. The velocity is that of half a step ago, distance / h.
///
/// @param x  position, advanced in place
/// @param distance  that the last step moved it, advanced in place; see
/// stormer_verlet_distance_start
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
/// @see E. Hairer, Ch. Lubich, G. Wanner, Geometric numerical integration illustrated by the
/// Stormer-Verlet method, Acta Numerica (2003)
template <class Vec, class Time, class Real, class Acceleration>
constexpr void stormer_verlet_distance(Vec& x, Vec& distance, Time t, Real h,
                                       Acceleration&& acceleration) {
  if constexpr (stormer_verlet_accepts<Vec, Time, Real, Acceleration>()) {
    // [distance-move]
    const Vec v = (Real(1) / h) * distance;
    distance = distance + (h * h) * acceleration(x, v, t);
    x = x + distance;
    // [distance-move]
  }
}

/// One step of position Verlet where the step may change from one to the next.
///
/// Order 2 in position, 1 in velocity and under drag, one evaluation of the acceleration, stable on
/// drag while c*h < 2, on an undamped spring while h*omega < 2. Without `h_previous` a change of
/// the step would change the speed.
///
/// @param x  position, advanced in place
/// @param x_previous  position one step ago, advanced in place; see stormer_verlet_start
/// @param t  time of `x` [s]
/// @param h  step size from `x` on [s]
/// @param h_previous  step size that led from `x_previous` to `x` [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [units of x per s^2]
template <class Vec, class Time, class Real, class Acceleration>
constexpr void stormer_verlet_uneven(Vec& x, Vec& x_previous, Time t, Real h, Real h_previous,
                                     Acceleration&& acceleration) {
  if constexpr (stormer_verlet_accepts<Vec, Time, Real, Acceleration>()) {
    // [uneven-move]
    const Vec v = stormer_verlet_velocity(x, x_previous, h_previous);
    const Vec a = acceleration(x, v, t);
    const Vec x_next = x + h * v + (h * (h + h_previous) / Real(2)) * a;
    x_previous = x;
    x = x_next;
    // [uneven-move]
  }
}

}  // namespace integrate
