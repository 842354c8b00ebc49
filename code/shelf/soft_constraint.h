// SPDX-License-Identifier: MIT-0
/// @file
/// A soft constraint as Box2D 3 has it: three numbers for a spring, stable at any step.
///
/// @code
/// // A hook of 2 kg on a soft joint, 5 Hz without damping, pulled 10 cm out of its place at 0.
/// const double h = 1 / 60.0, omega = 2 * 3.141592653589793 * 5, zeta = 0, w = 1 / 2.0;
/// const auto dot = [](double a, double b) { return a * b; };
/// const auto soft = shelf::softness(h, omega, zeta);
/// double wall = 0, x = 0.1, v = 0, impulse = 0;
/// for (int n = 0; n < 60; ++n) {
///   shelf::soft_warm_start(wall, v, impulse, 1.0, 0.0, w);
///   shelf::soft_constraint(wall, v, impulse, 1.0, x, 0.0, w, soft, dot);
///   x = x + h * v;
/// }
/// const auto real = shelf::soft_motion(h, omega, zeta);
/// // Now real.swing / (2 * 3.141592653589793) is 4.6061.
/// // Now real.zeta is 0.2436.
/// @endcode
///
/// Promises:
/// - the three numbers are right to 4 roundings, for h omega from 10^-6 to 1000
/// - from any warm start one solve ends at the same velocities, to 8 roundings of the speeds that
///   the warm start gives, and so do two and three
/// - what was asked for as 5 Hz swings at 3.86 Hz with 30 steps a second, at 4.61 with 60 and at
///   4.97 with 240
/// - its damping ratio then is 0.42, 0.24 and 0.065, where none was asked for
/// - soft_motion gives the places of 100 steps of a constraint, to 10^-12 of the first
/// - however large h omega is, up to 10^6, an undamped stretch with no speed never grows
#pragma once
#include <cmath>
#include <type_traits>

namespace shelf {

/// The factors of a soft constraint, for one step size. See softness.
template <class Real>
struct Softness {
  Real bias_rate;      ///< speed asked for by each metre of stretch [1/s]
  Real mass_scale;     ///< share of the mass that the impulse acts with, 0 to 1
  Real impulse_scale;  ///< share of the impulse so far that is taken back; 1 less the mass scale
};

/// The spring that a soft constraint really is. See soft_motion.
template <class Real>
struct SoftMotion {
  Real omega;  ///< natural frequency [rad/s]
  Real zeta;   ///< damping ratio
  Real swing;  ///< angular frequency that is seen, 0 if it creeps [rad/s]
};

/// The three numbers of a soft constraint.
///
/// The step of backward Euler for a spring x'' = -omega^2 x - 2 zeta omega x', written as impulses.
/// A frequency of 0, or next to it, gives a constraint that does nothing. Negative arguments, and
/// an h omega whose square is not finite, are meaningless.
///
/// @param h  step size, the substep if there are substeps [s]; above 0
/// @param omega  natural frequency asked for, 2 pi times the hertz [rad/s]; not negative
/// @param zeta  damping ratio asked for; not negative
/// @see E. Catto, Soft constraints, Game Developers Conference (2011)
/// @see Box2D 3, src/solver.h, b2MakeSoft
template <class Real>
constexpr Softness<Real> softness(Real h, Real omega, Real zeta) {
  static_assert(!std::is_integral_v<Real>, "h, omega and zeta must be no integers");
  const Real damping_and_step = Real(2) * zeta + h * omega;
  const Real stiff = h * omega * damping_and_step;
  if (!(omega > Real(0)) || !(stiff > Real(0))) return {Real(0), Real(0), Real(1)};
  return {omega / damping_and_step, stiff / (Real(1) + stiff), Real(1) / (Real(1) + stiff)};
}

/// Gives two bodies the impulse of the last step again, before the constraints are solved.
///
/// @param v1  velocity of the first body, changed in place [m/s]
/// @param v2  velocity of the second, changed in place [m/s]
/// @param impulse  what the constraint gave in the last step [N s]; times the ratio of the step
/// sizes if they differ, 0 if there is none
/// @param along  direction from the first to the second, of length 1
/// @param w1  1/m of the first body [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
template <class Vec, class Real>
constexpr void soft_warm_start(Vec& v1, Vec& v2, Real impulse, const Vec& along, Real w1, Real w2) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  static_assert(
      scales,
      "impulse * along must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(!std::is_integral_v<Real>, "impulse must be no integer");
  if constexpr (scales) {
    v1 = v1 + (-w1 * impulse) * along;
    v2 = v2 + (w2 * impulse) * along;
  }
}

/// Solves one soft constraint between two bodies, on their velocities.
///
/// Call it once or several times among other constraints, after the forces and before the places
/// are moved. With both bodies immovable it does nothing.
///
/// @param v1  velocity of the first body, changed in place [m/s]
/// @param v2  velocity of the second, changed in place [m/s]
/// @param impulse  what the constraint has given in this step so far, the warm start among it;
/// added to in place [N s]
/// @param along  direction from the first to the second, of length 1
/// @param stretch  how much too far apart they are at the start of the step [m]
/// @param w1  1/m of the first body [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
/// @param soft  see softness
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
template <class Vec, class Real, class Dot>
constexpr void soft_constraint(Vec& v1, Vec& v2, Real& impulse, const Vec& along, Real stretch,
                               Real w1, Real w2, const Softness<Real>& soft, Dot&& dot) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  static_assert(
      scales,
      "impulse * along must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  if constexpr (scales && dots) {
    if (!(w1 + w2 > Real(0))) return;
    const Vec parting = v2 + Real(-1) * v1;
    const Real speed = dot(parting, along);
    const Real change = -soft.mass_scale * (speed + soft.bias_rate * stretch) / (w1 + w2) -
                        soft.impulse_scale * impulse;
    impulse = impulse + change;
    soft_warm_start(v1, v2, change, along, w1, w2);
  }
}

/// The frequency and the damping that a soft constraint really has, in closed form.
///
/// What was asked for as an exact spring comes out of a step of backward Euler slower and more
/// damped. It calls the arc tangent and logarithm of the C library, and a square root.
///
/// @param h  step size, the substep if there are substeps [s]; above 0
/// @param omega  natural frequency asked for [rad/s]; above 0
/// @param zeta  damping ratio asked for; not negative
/// @returns  the exact spring that would be at the same places at the same steps
/// @see Hairer and Wanner, Solving Ordinary Differential Equations II (1996), section IV.3
template <class Real>
SoftMotion<Real> soft_motion(Real h, Real omega, Real zeta) {
  static_assert(!std::is_integral_v<Real>, "h, omega and zeta must be no integers");
  const Real angle = h * omega;
  const Real root = std::sqrt(std::abs((zeta - Real(1)) * (zeta + Real(1))));
  if (zeta < Real(1)) {
    const Real turned = std::atan2(angle * root, Real(1) + zeta * angle) / h;
    const Real decay = std::log1p(angle * (Real(2) * zeta + angle)) / (Real(2) * h);
    const Real rate = std::sqrt(turned * turned + decay * decay);
    return {rate, decay / rate, turned};
  }
  const Real fast = std::log1p(angle * (zeta + root)) / h;
  const Real slow = std::log1p(angle / (zeta + root)) / h;
  const Real rate = std::sqrt(fast) * std::sqrt(slow);
  return {rate, (fast + slow) / (Real(2) * rate), Real(0)};
}

}  // namespace shelf
