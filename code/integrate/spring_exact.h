// SPDX-License-Identifier: MIT-0
/// @file
/// The damped spring in closed form, for any step.
///
/// @code
/// double x = 1, v = 0;
/// const double omega = 3, zeta = 1 / 6.0;
/// for (int n = 0; n < 60; ++n) integrate::spring_exact(x, v, 1 / 60.0, omega, zeta);
/// @endcode
///
/// A camera that goes to its target. With zeta = 1 it does not overshoot from rest, nor if it comes
/// in no faster than omega times the way that is left. Faster, it passes the target once; where it
/// must not, stop it there:
/// @code
/// double camera = 0, speed = 0;
/// const double target = 10, before = camera - target;
/// double way = before;
/// integrate::spring_exact(way, speed, 1 / 60.0, 8.0, 1.0);
/// if (way * before < 0) way = speed = 0;
/// camera = target + way;
/// @endcode
///
/// A tail or an ear that swings after its bone: let its tip go to its place in the pose, as the
/// camera does, with a zeta below 1, and turn the bone to look at it.
///
/// Where all steps have one length, work its numbers out once. Then a step costs four
/// multiplications, for as many springs as have these numbers in common:
/// @code
/// double door = 1, swing = 0;
/// const auto step = integrate::spring_folded_start(1 / 60.0, 3.0, 1 / 6.0);
/// for (int n = 0; n < 60; ++n) integrate::spring_folded(door, swing, step);
/// @endcode
#pragma once
#include <cmath>
#include <type_traits>

namespace integrate {

/// One exact step of a damped spring as a matrix: x becomes xx*x + xv*v, v becomes vx*x + vv*v.
/// @see spring_folded_start
template <class Real>
struct SpringFolded {
  Real xx;  ///< part of the old position in the new position
  Real xv;  ///< part of the old velocity in the new position [s]
  Real vx;  ///< part of the old position in the new velocity [1/s]
  Real vv;  ///< part of the old velocity in the new velocity
};

/// The matrix of an exact step, worked out once for all steps of this length.
///
/// One formula serves a spring that swings (zeta < 1), one that creeps, and what lies between,
/// without loss of digits. The spring is `x'' = -omega^2 x - 2 zeta omega x'`.
///
/// @param h  step size [s]; a negative step goes back in time
/// @param omega  natural frequency [rad/s]; not negative
/// @param zeta  damping ratio; not negative
/// @see L. D. Landau and E. M. Lifshitz, Mechanics (1976), section 25
template <class Real>
SpringFolded<Real> spring_folded_start(Real h, Real omega, Real zeta) {
  static_assert(!std::is_integral_v<Real>, "h, omega and zeta must be no integers");
  const bool swings = zeta < Real(1);
  const Real root = std::sqrt(std::abs((zeta - Real(1)) * (zeta + Real(1))));
  const Real apart = omega * root;
  const Real decay = swings ? zeta * omega : omega / (zeta + root);
  // What a push has become, but for the decay: a sine, the time itself, or less than the time.
  const Real push = apart * h == Real(0) ? h
                    : swings             ? std::sin(apart * h) / apart
                                         : -std::expm1(Real(-2) * apart * h) / (Real(2) * apart);
  // What is left of x alone and of v alone, again but for the decay.
  const Real swing = swings ? std::cos(apart * h) : Real(1);
  const Real last = swings ? swing : std::exp(Real(-2) * apart * h);
  const Real left = std::exp(-decay * h);
  return {left * (swing + decay * push), left * push,  //
          -left * omega * omega * push, left * (last - decay * push)};
}

/// One exact step of a damped spring, by its matrix.
///
/// Exact for any h, no evaluation of the acceleration, stable on drag for every h, on an undamped
/// spring for every h. But h is the one that the matrix was made for: a frame of another length
/// needs a matrix of its own, or spring_exact.
///
/// @param x  position from where the spring is at rest, advanced in place
/// @param v  velocity, advanced in place
/// @param step  the matrix, from spring_folded_start
/// @see L. D. Landau and E. M. Lifshitz, Mechanics (1976), section 25
template <class Vec, class Real>
constexpr void spring_folded(Vec& x, Vec& v, const SpringFolded<Real>& step) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales, "the matrix times x must be a Vec: make it with the number type of Vec");
  if constexpr (scales) {
    // [move]
    const Vec x_start = x;
    x = step.xx * x_start + step.xv * v;
    v = step.vx * x_start + step.vv * v;
    // [move]
  }
}

/// A damped spring, moved on by any time without error.
///
/// Exact for any h, no evaluation of the acceleration, stable on drag for every h, on an undamped
/// spring for every h. It is what "smooth damp" should be: `x` is the way left to the target.
///
/// @param x  position from where the spring is at rest, advanced in place
/// @param v  velocity, advanced in place
/// @param h  step size [s]; a negative step goes back in time
/// @param omega  natural frequency [rad/s]; not negative
/// @param zeta  damping ratio; 0 swings for ever; at 1 it overshoots only if it comes in faster
/// than omega*|x|, above 1 only if faster still; not negative
/// @see L. D. Landau and E. M. Lifshitz, Mechanics (1976), section 25
template <class Vec, class Real>
void spring_exact(Vec& x, Vec& v, Real h, Real omega, Real zeta) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h, omega and zeta must be no integers");
  if constexpr (scales) spring_folded(x, v, spring_folded_start(h, omega, zeta));
}

}  // namespace integrate
