// SPDX-License-Identifier: MIT-0
/// @file
/// Following a target: a critically damped spring and plain smoothing, the same at every frame
/// rate.
///
/// @code
/// const double h = 1 / 60.0, omega = 4;  // omega = 2 / smoothTime, for who knows Unity's
/// double camera = 0, speed = 0, lift = 0, rising = 50, zoom = 1, red = 0;
/// for (int n = 0; n < 60; ++n) {
///   shelf::smooth_damp(camera, speed, 10.0, 0.0, omega, h);
///   shelf::smooth_damp_no_overshoot(lift, rising, 10.0, 0.0, omega, h,
///                                   [](double x, double y) { return x * y; });
///   shelf::smooth(zoom, 2.0, 0.0, 3.0, h);
///   red = red + shelf::smoothing_share(3.0, h) * (1 - red);  // or your slerp by it
/// }
/// // Now camera is 9.0842.
/// // Now lift is 9.8168.
/// // Now zoom is 1.9502.
/// // Now red is 0.9502.
/// // A drone, no faster than 5 m/s and no more accelerated than 20 m/s^2:
/// double drone = 0, flying = 0;
/// for (int n = 0; n < 60; ++n) {
///   shelf::smooth_damp_limited(drone, flying, 10.0, 0.0, omega, 5.0, 20.0, h,
///                              [](double x, double y) { return x * y; });
/// }
/// // Now drone is 4.220.
/// // Now flying is 4.998.
/// @endcode
///
/// A target that moves: hand over its velocity. The follower catches up with one that moves evenly
/// and stays with it; behind one that accelerates by a it stays about a/omega^2 back, less
/// where the steps are long, since it takes the velocity for constant within a step. To
/// trail behind it, aim as far behind: at `target + (-2 / omega) * target_velocity` with
/// smooth_damp, at `target + (-1 / rate) * target_velocity` with smooth. With a velocity of zero it
/// trails as well, but, like Unity's SmoothDamp, by half a frame less: by another way at each frame
/// rate. Unity's formula is that of Game Programming Gems 4.
///
/// A follower that may go no faster, as with Unity's maxSpeed, or may not be pushed harder:
/// smooth_damp_limited. To stop in time at a target at rest an acceleration of omega times its top
/// speed over e is enough while omega h is 0.5 at most; with much less, it passes its target.
///
/// Promises:
/// - smooth_damp from rest is the exact answer to 1e-14 of the way, for omega from 1 to 30 at 15,
///   30, 60, 120 and 240 Hz; Unity's formula is up to 0.036 of the way off
/// - with omega = 4 a second ends in the same place at each of these rates to 1e-14 of the way;
///   with Unity's formula the places are 3.9e-4 of it apart
/// - behind a target that moves evenly, aimed as said, it trails by the same way at each of these
///   rates to 1e-12; with Unity's formula, by 0.467 s at 15 Hz and 0.498 s at 240 Hz for omega = 4
/// - from rest it passes no target, at any of these rates and omegas
/// - smooth_damp_no_overshoot passes no target at any speed up to a hundred times omega times the
///   way, and a second of it ends in the same place at each of these rates to 1e-14 of the way
/// - smooth ends a second in the same place at each of these rates to 1e-14 of the way
/// - in float, ten seconds of smooth at 240 Hz with rate h = 1e-6 are right to 1e-5 of what was
///   moved; with 1 - exp(-rate h) in place of expm1 they are 0.013 off
/// - one step of a million seconds ends on a target at rest to the last bit but one
/// - with omega = 4 and a top speed of 5 m/s, smooth_damp_limited is never more than 2.6e-4 m off
///   on its 10 m at 60 Hz; Unity's formula with its maxSpeed is up to 0.13 m off
/// - with a top acceleration of 20 m/s^2 as well, it is never more than 9.7e-4 m off there
/// - behind what moves, up to ten times as fast, its speed stays within the top speed, to 1e-13 of
///   it, for omega h up to 2
/// - towards what rests its speed and its acceleration stay within their limits from rest on, to
///   1e-13 of them, in frames of any length, and a top acceleration of omega times the top speed
///   over e lets it pass no target by 1e-5 of the way while omega h is 0.5 at most
#pragma once
#include <cmath>
#include <type_traits>

namespace shelf {

// Targets are of type std::decay_t<Vec>, which is Vec: so they may be sums such as those above, of
// whatever type a library gives them, and numbers that become a Vec.

/// The share of the way that smoothing goes in a step: 1 - exp(-rate h), by expm1, which keeps its
/// digits where rate h is small. Hand it to a lerp of your own, or to a slerp.
///
/// Calls expm1 of the C library: the last bit may differ from one library to another.
///
/// @param rate  how fast [1/s]: in 1 / rate seconds, 63 % of the way; not negative
/// @param h  step size [s]; not negative
/// @returns  between 0 and 1
template <class Real>
Real smoothing_share(Real rate, Real h) {
  static_assert(!std::is_integral_v<Real>, "rate and h must be no integers");
  return -std::expm1(-rate * h);
}

/// One step of smoothing towards a target: the way that is left shrinks by exp(-rate h).
///
/// When the target jumps, the follower's velocity does; where that shows, take smooth_damp. Calls
/// expm1 of the C library.
///
/// @param x  position of the follower, advanced in place
/// @param target  where the target is at the end of the step
/// @param target_velocity  with which it has come there; zero, if it rests between its jumps
/// @param rate  how fast [1/s]; not negative
/// @param h  step size [s]; finite, not negative
/// @see R. Driscoll, Frame rate independent damping using lerp (2016)
template <class Vec, class Real>
void smooth(Vec& x, const std::decay_t<Vec>& target, const std::decay_t<Vec>& target_velocity,
            Real rate, Real h) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "rate and h must be no integers");
  if constexpr (scales) {
    // [smooth]
    const Vec way = x + Real(-1) * target + h * target_velocity;
    x = x + (std::expm1(-rate * h) * way + h * target_velocity);
    // [smooth]
  }
}

/// One step of a critically damped spring towards a target, exact for any h.
///
/// The follower starts and stops softly. Whatever comes in faster than omega times the way that is
/// left passes the target, once; see smooth_damp_no_overshoot. The spring is that of spring_exact.h
/// with zeta = 1. Calls exp and expm1 of the C library: the last bits may differ from one library
/// to another.
///
/// @param x  position of the follower, advanced in place
/// @param v  its velocity, advanced in place
/// @param target  where the target is at the end of the step
/// @param target_velocity  with which it has come there; zero, if it rests between its jumps
/// @param omega  how fast [rad/s], 2 / smoothTime in Unity's words; not negative
/// @param h  step size [s]; finite, not negative
/// @see T. Lowe, Critically damped ease-in/ease-out smoothing, Game Programming Gems 4 (2004),
/// section 1.10, which takes a fraction for the exponential
template <class Vec, class Real>
void smooth_damp(Vec& x, Vec& v, const std::decay_t<Vec>& target,
                 const std::decay_t<Vec>& target_velocity, Real omega, Real h) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "omega and h must be no integers");
  if constexpr (scales) {
    // [smooth-damp]
    const Vec way = x + Real(-1) * target + h * target_velocity;
    const Vec speed = v + Real(-1) * target_velocity;
    const Real left = std::exp(-omega * h), lost = std::expm1(-omega * h);
    const Real pull = omega * h * left;
    x = x + ((lost + pull) * way + (h * left) * speed + h * target_velocity);
    v = v + ((lost - pull) * speed + (-omega * pull) * way);
    // [smooth-damp]
  }
}

/// smooth_damp that never passes its target: what comes in too fast is braked at the start of the
/// step, to omega times the way that is left. Once that slow it stays so, and so the brake does
/// nothing in the steps that follow, and no frame rate changes it.
///
/// Of a vector only the part towards the target is braked. What moves sideways swings round it. A
/// way whose square is zero (below 1e-23 in float) is not braked. Calls exp and expm1 of the C
/// library.
///
/// @param x  position of the follower, advanced in place
/// @param v  its velocity, advanced in place
/// @param target  where the target is at the end of the step
/// @param target_velocity  with which it has come there; zero, if it rests between its jumps
/// @param omega  how fast [rad/s]; not negative
/// @param h  step size [s]; finite, not negative
/// @param dot  callable `(Vec, Vec) -> Real`: the product of two numbers, the dot product of
/// vectors
template <class Vec, class Real, class Dot>
void smooth_damp_no_overshoot(Vec& x, Vec& v, const std::decay_t<Vec>& target,
                              const std::decay_t<Vec>& target_velocity, Real omega, Real h,
                              Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(x, y)");
  static_assert(!std::is_integral_v<Real>, "omega and h must be no integers");
  if constexpr (scales && dots) {
    // [no-overshoot]
    const Vec way = x + Real(-1) * target + h * target_velocity;
    const Vec speed = v + Real(-1) * target_velocity;
    const Real square = dot(way, way);
    const Real slack = dot(way, speed) + omega * square;
    if (slack < Real(0) && square > Real(0)) v = v + (-slack / square) * way;
    smooth_damp(x, v, target, target_velocity, omega, h);
    // [no-overshoot]
  }
}

/// smooth_damp with a top speed and a top acceleration, either of which may be infinite, as
/// `std::numeric_limits<double>::infinity()` is.
///
/// The spring is one that asks for a velocity, target_velocity + (omega / 2) * way, and comes to it
/// at the rate 2 omega: what it asks for is cut to the top speed, and how it comes there to the top
/// acceleration. On a line it is exact while one limit holds or none does; in a plane, and in a
/// step in which that changes, it is off by something like h^3. A follower that is too fast already
/// is braked. Calls exp and expm1 of the C library.
///
/// @param x  position of the follower, advanced in place
/// @param v  its velocity, advanced in place
/// @param target  where the target is at the end of the step
/// @param target_velocity  with which it has come there; zero, if it rests between its jumps
/// @param omega  how fast [rad/s]; not negative
/// @param top_speed  of the follower, target or no target; not negative
/// @param top_acceleration  of the follower; not negative
/// @param h  step size [s]; finite, not negative
/// @param dot  callable `(Vec, Vec) -> Real`: the product of two numbers, the dot product of
/// vectors
template <class Vec, class Real, class Dot>
void smooth_damp_limited(Vec& x, Vec& v, const std::decay_t<Vec>& target,
                         const std::decay_t<Vec>& target_velocity, Real omega, Real top_speed,
                         Real top_acceleration, Real h, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(x, y)");
  static_assert(!std::is_integral_v<Real>, "omega and h must be no integers");
  if constexpr (scales && dots) {
    // [limited]
    const Vec place = x, velocity = v;
    const Vec way = target + Real(-1) * x + (-h) * target_velocity;
    const Vec wanted = target_velocity + (omega / Real(2)) * way;
    const Real speed = std::sqrt(dot(wanted, wanted));
    if (speed > top_speed) {
      // Where it turns meanwhile, what it asks for in the middle of the step; only the turn of it.
      const Vec turns = (omega * h / Real(4)) * (target_velocity + Real(-1) * v);
      const Vec turned = wanted + turns + (-dot(turns, wanted) / (speed * speed)) * wanted;
      const Vec top = (top_speed / std::sqrt(dot(turned, turned))) * turned;
      const Vec excess = v + Real(-1) * top;
      const Real lost = std::expm1(Real(-2) * omega * h);
      x = x + (h * top + (omega > Real(0) ? lost / (Real(-2) * omega) : h) * excess);
      v = v + lost * excess;
    } else {
      smooth_damp(x, v, target, target_velocity, omega, h);
      // What moves may ask for more before the step is over.
      const auto no_longer = [&dot](const Vec& y, Real most) -> Vec {
        const Real length = std::sqrt(dot(y, y));
        if (!(length > most)) return y;
        return (most / length) * y;
      };
      const Real before = std::sqrt(dot(velocity, velocity));
      const Real fastest = before > top_speed ? before : top_speed;
      const Vec moved = x + Real(-1) * place;
      v = no_longer(v, fastest);
      if (dot(moved, moved) > h * h * fastest * fastest) x = place + no_longer(moved, h * fastest);
    }
    const Vec change = v + Real(-1) * velocity;
    const Real size = std::sqrt(dot(change, change));
    if (size > top_acceleration * h) {
      v = velocity + (top_acceleration * h / size) * change;
      x = place + (h / Real(2)) * (velocity + v);
    }
    // [limited]
  }
}

}  // namespace shelf
