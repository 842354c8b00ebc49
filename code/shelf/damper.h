// SPDX-License-Identifier: MIT-0
/// @file
/// A damper between two bodies: it slows how fast they part, and leaves their momentum alone.
///
/// @code
/// const double h = 1 / 60.0, c = 30;              // a shock absorber of 30 N for each m/s
/// double truck = 12, trailer = 10;                // m/s
/// const double w_truck = 1 / 2.0, w_trailer = 1;  // a toy: 2 kg and 1 kg
/// for (int n = 0; n < 60; ++n) shelf::damper(truck, trailer, h, c, w_truck, w_trailer);
/// // Now truck is 11.333333.
/// // Now trailer is 11.333333.
/// @endcode
///
/// Along a line alone, as in a strut. A complex number is a vector, right and up:
/// @code
/// #include <complex>
/// using Flat = std::complex<double>;
/// const auto dot = [](Flat p, Flat q) { return p.real() * q.real() + p.imag() * q.imag(); };
/// Flat wheel(20, 3), car(20, 0);
/// shelf::damper_along(wheel, car, 1 / 60.0, 3000.0, 1 / 20.0, 1 / 300.0, Flat(0, 1), dot);
/// // Now wheel.imag() is 0.9545.
/// // Now car.imag() is 0.1364.
/// // Now wheel.real() is 20.
/// @endcode
///
/// In a row that carries a load, one pass hands the load on by one body: however strong its
/// dampers, it gives way. Ten kilograms that hang in a row, braked from the top down, sink by 7.4
/// m/s in steps of 1/60 s, and by 0.9 to 1.0 with 8 substeps. Solve such a row at once, by
/// band_system.h.
///
/// Promises:
/// - the speed of parting is divided by 1 + h c (1/m1 + 1/m2), to 4 roundings of the speeds, for
///   masses from 1 g to 1 t
/// - momentum is kept, to 2 roundings of m1 |v1| + m2 |v2|
/// - however large h c is, up to 10^30 kg, the two never part the other way, but for 2 roundings
///   of the speeds
/// - a body of inverse mass 0 keeps its velocity to the bit
/// - along a line, the velocities across it stay to the bit if the line is an axis, and to 2
///   roundings if not
#pragma once
#include <type_traits>

namespace shelf {

/// Damps the whole velocity of one body seen from the other, along and across.
///
/// The step of backward Euler: the damper pulls as the velocity at the end of the step asks for. So
/// the part of it that is left is 1/(1 + h c w) where exp(-h c w) would be exact, w being the sum
/// of the inverse masses, and any h c is safe. Call it after the forces and before the places. With
/// both bodies immovable it does nothing. A negative h or c, and a number that is not finite, is
/// meaningless.
///
/// @param v1  velocity of the first body, changed in place [m/s]
/// @param v2  velocity of the second, changed in place [m/s]
/// @param h  step size [s]; not negative
/// @param c  force of the damper for each unit of speed [N s/m]; not negative
/// @param w1  1/m of the first body [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.2
template <class Vec, class Real>
constexpr void damper(Vec& v1, Vec& v2, Real h, Real c, Real w1, Real w2) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales) {
    const Vec parting = v2 + Real(-1) * v1;
    const Vec impulse = (h * c / (Real(1) + h * c * (w1 + w2))) * parting;
    v1 = v1 + w1 * impulse;
    v2 = v2 + (-w2) * impulse;
  }
}

/// Damps only the speed at which two bodies part along a line, as a shock absorber does.
///
/// @param v1  velocity of the first body, changed in place [m/s]
/// @param v2  velocity of the second, changed in place [m/s]
/// @param h  step size [s]; not negative
/// @param c  force of the damper for each unit of speed [N s/m]; not negative
/// @param w1  1/m of the first body [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
/// @param along  the line's direction, of length 1
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @see damper, for what it does and what is meaningless
template <class Vec, class Real, class Dot>
constexpr void damper_along(Vec& v1, Vec& v2, Real h, Real c, Real w1, Real w2, const Vec& along,
                            Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && dots) {
    const Vec parting = v2 + Real(-1) * v1;
    const Real speed = dot(parting, along);
    const Real impulse = h * c / (Real(1) + h * c * (w1 + w2)) * speed;
    v1 = v1 + (w1 * impulse) * along;
    v2 = v2 + (-w2 * impulse) * along;
  }
}

}  // namespace shelf
