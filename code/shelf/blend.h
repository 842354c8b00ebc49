// SPDX-License-Identifier: MIT-0
/// @file
/// What to draw between two steps: straight on, along a curve, or turned.
///
/// @code
/// #include <complex>
///
/// // Round a lamp, at 3 rad/s, in 20 steps a second; right between two of them.
/// using Flat = std::complex<double>;
/// const double h = 1 / 20.0, share = 0.5;
/// const Flat before = 1, now = std::polar(1.0, 3 * h);
/// const Flat v_before = Flat(0, 3) * before, v_now = Flat(0, 3) * now;
/// const Flat straight = shelf::blend(before, now, share);
/// const Flat curved = shelf::blend_curved(before, v_before, now, v_now, h, share);
/// // And its nose, a direction of length one, as a quaternion is in space.
/// const auto dot = [](Flat p, Flat q) { return p.real() * q.real() + p.imag() * q.imag(); };
/// const Flat nose = shelf::blend_turned(v_before / 3.0, v_now / 3.0, share, dot);
/// // Now std::abs(straight) is 0.99719.
/// // Now std::abs(curved) is 0.999999.
/// // Now std::abs(nose) is 1.00000.
/// @endcode
///
/// `share` is how far the screen is between the two, `blend()` of fixed_step.h. Keep a copy of what
/// was before the last step; and where something is put elsewhere, copy what is now over it, too,
/// so that it is not seen on its way. A direction may turn by less than a quarter of a turn between
/// the two, a quaternion's by less than a half. A curve knows nothing of a bounce: where the speed
/// has jumped, blend straight.
///
/// A quaternion of yours that has `+` and `*` is turned as it is, by its own dot product; of others
/// hand over the four numbers in a vector.
///
/// Promises:
/// - a metre round a lamp, at 3 rad/s in 20 steps a second, the straight blend is 2.8 mm inside
/// - there the curved one is 1.3 thousandths of a millimetre off
/// - in steps half as long the straight one is a quarter as far off, and the curved one a
///   sixteenth, to an order of 0.01
/// - at 0 and at 1 both are one of the two places, to the last bit
/// - in float, 10 km from the origin, no blend of an even motion is further off than two places of
///   a float
/// - what turns evenly, by up to 3 rad between two steps, is off by less than 0.0046 of the cube of
///   that angle, and in the middle by nothing but rounding
/// - the length of what is turned stays one, to 1e-15
#pragma once
#include <cmath>
#include <type_traits>

namespace shelf {

/// Straight on from one place to another.
///
/// Calls nothing of the C library.
///
/// @param before  the older place
/// @param now  the newer one
/// @param share  of the way, between 0 and 1
/// @returns  one of the two to the bit, at 0 and at 1
template <class Vec, class Real>
constexpr Vec blend(const Vec& before, const std::decay_t<Vec>& now, Real share) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales, "share * x must be a Vec: copy a column or Map");
  static_assert(!std::is_integral_v<Real>, "share must be no integer");
  if constexpr (scales) {
    // [straight]
    const Vec way = now + Real(-1) * before;
    if (share < Real(0.5)) return before + share * way;
    return now + (share - Real(1)) * way;
    // [straight]
  } else {
    return before;
  }
}

/// From one place to another along the curve that leaves and comes with the velocities there.
///
/// Off by h^4 / 384 times the fourth derivative of the path at most, where a straight line is off
/// by h^2 / 8 times the second. Calls nothing of the C library.
///
/// @param before  the older place
/// @param v_before  velocity there
/// @param now  the newer place
/// @param v_now  velocity there
/// @param h  time between the two [s]
/// @param share  of that time, between 0 and 1
/// @returns  one of the two places to the bit, at 0 and at 1
/// @see C. Hermite, Sur la formule d'interpolation de Lagrange (1878)
template <class Vec, class Real>
constexpr Vec blend_curved(const Vec& before, const std::decay_t<Vec>& v_before,
                           const std::decay_t<Vec>& now, const std::decay_t<Vec>& v_now, Real h,
                           Real share) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h and share must be no integers");
  if constexpr (scales) {
    // [curved]
    const Real left = Real(1) - share;
    const Vec way = now + Real(-1) * before;
    const Vec bend = (h * share * left) * (left * v_before + (-share) * v_now);
    if (share < Real(0.5))
      return before + ((share * share * (Real(1) + Real(2) * left)) * way + bend);
    return now + ((-left * left * (Real(1) + Real(2) * share)) * way + bend);
    // [curved]
  } else {
    return before;
  }
}

/// Between two orientations, by the shorter way round. Two unit quaternions that differ in sign
/// alone are one orientation.
///
/// In the middle it is where even turning is, and elsewhere not far off: see the promises. Calls a
/// square root.
///
/// @param before  the older one, of length one
/// @param now  the newer one, of length one
/// @param share  of the way, between 0 and 1
/// @param dot  callable `(Quaternion, Quaternion) -> Real`, the sum of the products of their
/// numbers
/// @returns  of length one
template <class Quaternion, class Real, class Dot>
Quaternion blend_turned(const Quaternion& before, const std::decay_t<Quaternion>& now, Real share,
                        Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Quaternion, decltype(scale), Real, Quaternion>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Quaternion&, const Quaternion&>;
  static_assert(scales, "share * q must be a Quaternion: hand over its four numbers in a vector");
  static_assert(dots, "dot must be callable as Real(p, q)");
  static_assert(!std::is_integral_v<Real>, "share must be no integer");
  if constexpr (scales && dots) {
    // [turned]
    const Real side = dot(before, now) < Real(0) ? Real(-1) : Real(1);
    const Quaternion between = (Real(1) - share) * before + (side * share) * now;
    return Real(1) / std::sqrt(dot(between, between)) * between;
    // [turned]
  } else {
    return before;
  }
}

}  // namespace shelf
