// SPDX-License-Identifier: MIT-0
/// @file
/// Damping within a step of symplectic Euler: six ways of the engines, and the exact one.
///
/// @code
/// const auto spring = [](double x, double, double) { return -9 * x; };  // all but the damping
/// const double h = 1 / 60.0, c = 1;
/// double x = 1, v = 0;
/// for (int n = 0; n < 60; ++n) {
///   integrate::linear_damping_implicit_last(x, v, n * h, h, c, spring);
/// }
/// @endcode
///
/// What is damped is the speed in the world: it is drag, or a damper whose other end is fixed. A
/// damper between two bodies, of d newtons for each metre per second, must damp the speed at which
/// they part, or it brakes both of them against the world. Divide that speed by 1 + d*h*(1/m1 +
/// 1/m2), and what it loses goes into both as one impulse:
/// @code
/// const double m1 = 1, m2 = 2, stiffness = 6, d = 2 / 3.0;
/// const double light = 1 / m1 + 1 / m2;
/// double x1 = 0, v1 = 10, x2 = 1, v2 = 10;
/// for (int n = 0; n < 60; ++n) {
///   const double pull = stiffness * (x2 - x1);
///   v1 += h * pull / m1, v2 -= h * pull / m2;
///   const double parting = v2 - v1;
///   const double impulse = (parting - parting / (1 + d * h * light)) / light;
///   v1 += impulse / m1, v2 -= impulse / m2;
///   x1 += h * v1, x2 += h * v2;
/// }
/// x = x2 - x1, v = v2 - v1;  // the same motion as above, while both go on at 10 m/s
/// @endcode
#pragma once
#include <cmath>
#include <type_traits>

namespace integrate {

// Checks that a damped step can use these types; what one lacks is a compile error that says so.
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr bool linear_damping_accepts() {
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

/// Symplectic Euler with damping: the force, then the speed times 1 - c*h (PhysX, Jolt).
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. The factor is never below zero: from c*h = 1 on, the thing stands still. On
/// poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, but not out of a standstill
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void linear_damping_explicit_last(Position& x, Vec& v, Time t, Real h, Real c,
                                            Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    const Vec a = acceleration(x, v, t);
    const Real keep = Real(1) - c * h;
    v = (keep > Real(0) ? keep : Real(0)) * Vec(v + h * a);
    x = x + h * v;
  }
}

/// Symplectic Euler with damping: the speed times 1 - c*h, then the force (Godot).
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. The factor is never below zero. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, but not out of a standstill
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void linear_damping_explicit_first(Position& x, Vec& v, Time t, Real h, Real c,
                                             Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    const Vec a = acceleration(x, v, t);
    const Real keep = Real(1) - c * h;
    v = (keep > Real(0) ? keep : Real(0)) * v + h * a;
    x = x + h * v;
  }
}

/// Symplectic Euler with damping: the force, then the speed over 1 + c*h (solver2d, Box2D 2).
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time while c*|h| < 1; at 1 v is infinite
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void linear_damping_implicit_last(Position& x, Vec& v, Time t, Real h, Real c,
                                            Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    // [implicit-last-move]
    const Vec a = acceleration(x, v, t);
    v = (Real(1) / (Real(1) + c * h)) * Vec(v + h * a);
    x = x + h * v;
    // [implicit-last-move]
  }
}

/// Symplectic Euler with damping: the speed over 1 + c*h, then the force (Box2D 3, Avian).
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time while c*|h| < 1; at 1 v is infinite
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
constexpr void linear_damping_implicit_first(Position& x, Vec& v, Time t, Real h, Real c,
                                             Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    // [implicit-first-move]
    const Vec a = acceleration(x, v, t);
    v = (Real(1) / (Real(1) + c * h)) * v + h * a;
    x = x + h * v;
    // [implicit-first-move]
  }
}

/// Symplectic Euler with damping: the force, then the speed times exp(-c*h).
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, and takes back the damping
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
void linear_damping_exponential_last(Position& x, Vec& v, Time t, Real h, Real c,
                                     Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    const Vec a = acceleration(x, v, t);
    v = std::exp(-c * h) * Vec(v + h * a);
    x = x + h * v;
  }
}

/// Symplectic Euler with damping: the speed times exp(-c*h), then the force (Bullet, Chipmunk).
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, and takes back the damping
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
void linear_damping_exponential_first(Position& x, Vec& v, Time t, Real h, Real c,
                                      Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    const Vec a = acceleration(x, v, t);
    v = std::exp(-c * h) * v + h * a;
    x = x + h * v;
  }
}

/// Symplectic Euler with damping: the exact velocity of damping and a constant force together.
///
/// Order 1, one evaluation of the acceleration, stable on drag for every h, on an undamped spring
/// while h*omega < 2. The velocity under gravity and drag is exact, the terminal speed with it; the
/// position is not. Where a constant acceleration a and the damping are all, what moves it exactly,
/// in place of `x + h * v`, is `x + push * v + ((h - push) / c) * a` with the v from before the
/// step and push = (1 - exp(-c*h)) / c. On poses, order 1.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]; a negative step goes back in time, and takes back damping and force
/// @param c  damping per mass [1/s]; not negative
/// @param acceleration  of all forces but the damping, callable `(x, v, t) -> Vec`
template <class Position, class Vec, class Time, class Real, class Acceleration>
void linear_damping_exact(Position& x, Vec& v, Time t, Real h, Real c,
                          Acceleration&& acceleration) {
  if constexpr (linear_damping_accepts<Position, Vec, Time, Real, Acceleration>()) {
    const Vec a = acceleration(x, v, t);
    const Real push = c * h == Real(0) ? h : -std::expm1(-c * h) / c;
    v = std::exp(-c * h) * v + push * a;
    x = x + h * v;
  }
}

}  // namespace integrate
