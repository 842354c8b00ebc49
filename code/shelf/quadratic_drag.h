// SPDX-License-Identifier: MIT-0
/// @file
/// Drag that grows with the square of the speed: bullets, shells, parachutes, balls.
///
/// @code
/// #include <complex>
///
/// // A tennis ball, served at 50 m/s, against a wind of 5 m/s.
/// const auto norm = [](const std::complex<double>& v) { return std::abs(v); };
/// const std::complex<double> gravity(0, -9.81), wind(-5, 0);
/// const double k = 0.02, h = 1 / 60.0;
/// std::complex<double> ball(0, 2.5), speed(50, 0);
/// for (int n = 0; n < 30; ++n) {
///   shelf::quadratic_drag(ball, speed, gravity, wind, k, h, norm);
/// }
/// // And straight down: ten seconds of a fall that ends at 55 m/s, in one step.
/// double fallen = 0, falling = 0;
/// shelf::quadratic_drag_fall(fallen, falling, 9.81, 9.81 / (55 * 55), 10.0);
/// // Now ball.real() is 19.41.
/// // Now ball.imag() is 1.43.
/// // Now fallen is 344.8.
/// // Now falling is 52.0.
/// @endcode
///
/// The drag is k |v| v, in metres per second squared, where v is the speed through the air. `k` is
/// half the density of the air times area and drag coefficient, over the mass [1/m]; or gravity
/// over the square of the speed at which it falls in the end. On a way of 0.69 / k it loses half of
/// its speed, if nothing else moves it.
///
/// `quadratic_drag` takes what pushes besides the air, gravity and thrust, as it is at the start of
/// the step. Where only the air brakes it is exact. What falls ends a little too fast, by a share
/// of k |a| h^2 / 8: 1.3e-4 of a parachute's 5 m/s at 60 Hz, and 1 % where the last speed is 0.6
/// m/s. Fluff falls more slowly; for it take linear_damping.h.
///
/// Promises:
/// - along a line it is where fine steps of RK4 take it, up and down, to 1e-12 of the way, for h k
///   v up to 18
/// - in any direction, with gravity and wind, it has order 2 to 0.02
/// - a tennis ball at 50 m/s is less than 0.2 mm off after a second, in steps of 1/60 s
/// - what nothing pushes ends a second in the same place at 15, 30, 60, 120 and 240 Hz, to 1e-14 of
///   the way
/// - it ends too fast by a share of k |a| h^2 / 8, to a tenth of that, for last speeds from 0.6 to
///   5 m/s at 60 Hz
/// - both stay numbers for h k v from 1e-6 to 1e29, where RK4 is none after 20 steps with 2.5
#pragma once
#include <cmath>
#include <limits>
#include <type_traits>

namespace shelf {

/// What the steps are made of: a way along a line, the speed behind it, and how both come about.
template <class Real>
struct DraggedWay {
  Real way;    ///< [m]
  Real speed;  ///< at its end [m/s]

  /// log(1 + y) / y, also for y = 0, and 0 where y is beyond any number.
  /// @param y  not below -1
  static Real log1p_over(Real y) {
    if (!(y < (std::numeric_limits<Real>::max)())) return Real(0);
    return y > Real(0) || y < Real(0) ? std::log1p(y) / y : Real(1);
  }

  /// Against a pull, until it stops at the latest.
  /// @param u  speed with the pull, below zero [m/s]
  /// @param pull  acceleration by all but the drag [m/s^2]; not negative
  /// @param k  drag per mass and squared speed [1/m]; not negative
  /// @param h  no longer than it takes to stop [s]
  static DraggedWay rise(Real u, Real pull, Real k, Real h) {
    // [rise]
    const Real w = std::sqrt(pull * k), half = w * h / Real(2);
    const Real once = half > Real(0) ? std::sin(w * h) / w : h;
    const Real twice = half > Real(0) ? std::sin(half) / half : Real(1);
    const Real back = -u * once - pull * h * h / Real(2) * twice * twice;
    const Real s = half > Real(0) ? std::tan(w * h) / w : h;
    return {-back * log1p_over(k * back), (u + pull * s) / (Real(1) - k * u * s)};
    // [rise]
  }

  /// With a pull, or without one.
  /// @param u  speed with the pull, not below zero [m/s]
  /// @param pull  acceleration by all but the drag [m/s^2]; not negative
  /// @param k  drag per mass and squared speed [1/m]; not negative
  /// @param h  step size [s]; above zero
  static DraggedWay sink(Real u, Real pull, Real k, Real h) {
    // [sink]
    const Real w = std::sqrt(pull * k), half = w * h / Real(2);
    const Real s = half > Real(0) ? std::tanh(w * h) / w : h;
    const Real speed = (u + pull * s) / (Real(1) + k * u * s);
    if (half > Real(1)) {  // where sinh would soon be beyond any number
      const Real lead = (Real(1) - k * u / w) / Real(2) * std::expm1(Real(-2) * w * h);
      return {(w * h + std::log1p(lead)) / k, speed};
    }
    const Real once = half > Real(0) ? std::sinh(w * h) / w : h;
    const Real twice = half > Real(0) ? std::sinh(half) / half : Real(1);
    const Real ahead = u * once + pull * h * h / Real(2) * twice * twice;
    return {ahead * log1p_over(k * ahead), speed};
    // [sink]
  }
};

/// One step under a push and a drag that goes with the square, in any direction: half of the push,
/// the exact step of the drag, the other half.
///
/// Order 2, exact without a push, stable for every h. Calls log1p of the C library: the last bit
/// may differ from one library to another.
///
/// @param x  position, advanced in place
/// @param v  velocity, advanced in place
/// @param a  acceleration by all but the drag [units of x per s^2]
/// @param wind  velocity of the air
/// @param k  drag per mass and squared speed [1/m]; not negative
/// @param h  step size [s]; not negative
/// @param norm  callable `(Vec) -> Real`, the length of a vector
template <class Vec, class Real, class Norm>
void quadratic_drag(Vec& x, Vec& v, const std::decay_t<Vec>& a, const std::decay_t<Vec>& wind,
                    Real k, Real h, Norm&& norm) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "k and h must be no integers");
  if constexpr (scales && measures) {
    // [any-way]
    const Vec push = (h / Real(2)) * a;
    const Vec through = v + push + Real(-1) * wind;
    const Real y = h * k * norm(through);
    x = x + (h * wind + (h * DraggedWay<Real>::log1p_over(y)) * through);
    v = Real(1) / (Real(1) + y) * through + wind + push;
    // [any-way]
  }
}

/// One step along a line, under a push that stays and a drag that goes with the square, exact for
/// any h: up and down again, slower or faster than it falls in the end.
///
/// Against wind, hand over the speed through the air, and add the wind's way. Calls tan, tanh and
/// others of the C library: the last bits may differ from one library to another.
///
/// @param x  place along the line, advanced in place [m]
/// @param v  speed along it, advanced in place [m/s]
/// @param a  acceleration by all but the drag, in the direction of x [m/s^2]
/// @param k  drag per mass and squared speed [1/m]; not negative
/// @param h  step size [s]; not negative
template <class Real>
void quadratic_drag_fall(Real& x, Real& v, Real a, Real k, Real h) {
  static_assert(!std::is_integral_v<Real>, "x, v, a, k and h must be no integers");
  // [fall]
  const Real side = a < Real(0) ? Real(-1) : Real(1);  // as if it were pulled ahead
  const Real pull = side * a;
  DraggedWay<Real> now{Real(0), side * v};
  if (now.speed < Real(0)) {
    const Real w = std::sqrt(pull * k), q = -now.speed * w / pull;
    const Real stops = q > Real(0) ? std::atan(q) / w : -now.speed / pull;
    const bool turns = pull > Real(0) && stops < h;
    now = DraggedWay<Real>::rise(now.speed, pull, k, turns ? stops : h);
    if (turns) now.speed = Real(0);
    h = turns ? h - stops : Real(0);
  }
  if (h > Real(0)) {
    const DraggedWay<Real> then = DraggedWay<Real>::sink(now.speed, pull, k, h);
    now = {now.way + then.way, then.speed};
  }
  x = x + side * now.way;
  v = side * now.speed;
  // [fall]
}

}  // namespace shelf
