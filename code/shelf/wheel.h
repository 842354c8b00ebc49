// SPDX-License-Identifier: MIT-0
/// @file
/// The wheels of a car: each one ray, one spring and one damper under a chassis.
///
/// @code
/// #include "orientation.h"
/// // 1200 kg, let go 20 cm above the ground and aslant.
/// const shelf::Vec3<double> up{0, 1, 0};
/// const shelf::Vec3<double> inertia = shelf::inertia_of_box(1200.0, {4, 0.8, 1.7});
/// const shelf::Vec3<double> mounts[] = {
///     {1.4, 0, 0.75}, {1.4, 0, -0.75}, {-1.4, 0, 0.75}, {-1.4, 0, -0.75}};
/// const shelf::Suspension<double> suspension{30e3, 3e3};  // N/m, N s/m
/// const double mass = 1200, h = 1 / 60.0;
/// shelf::Vec3<double> x{0, 0.9, 0}, v, L, r[4];
/// shelf::Quaternion<double> q;
/// shelf::turn_exact(q, {0.1, 0, 0.15}, 1);
/// double force[4] = {0, 0, 0, 0};
/// const auto push = [&](const shelf::Vec3<double>& where, double by) {
///   v = v + (by / mass) * up;
///   L = L + cross(where, by * up);
/// };
/// for (int n = 0; n < 60 * 5; ++n) {
///   v = v + (-h * 9.81) * up;
///   for (int i = 0; i < 4; ++i) {
///     r[i] = shelf::rotate(q, mounts[i]);
///     push(r[i], h * force[i]);  // what it carried in the last step
///   }
///   for (int i = 0; i < 4; ++i) {
///     const double upright = shelf::rotate(q, up).y;  // on its roof its rays meet nothing
///     const double ray = upright > 0 ? (x + r[i]).y / upright : 1;  // your ray cast
///     const double rises = dot(v + cross(shelf::angular_velocity(q, L, inertia), r[i]), up);
///     const double w = shelf::inverse_mass_at(q, inertia, 1 / mass, r[i], up);
///     push(r[i], shelf::wheel_push(force[i], 0.7 - ray, rises, w, suspension, h));
///   }
///   x = x + h * v;
///   shelf::spin_by_rotations(q, L, inertia, h);
/// }
/// // Now x.y is 0.6019.
/// // Now 4 * force[0] / mass is 9.8100.
/// @endcode
///
/// The ray starts at the mount and is as long as the strut and the wheel together, 0.7 m here. By
/// as much as the ground cuts off it, the spring is compressed. The push is along the ground's
/// normal: `up` here, and the speed of the mount is that along it, less the ground's if the ground
/// moves. The mass that a wheel feels is that of `inverse_mass_at`: of a car about a quarter.
/// Hand over that of the whole car, and strong dampers throw it.
///
/// Write the force into your car: it is what the tyre's grip is a share of, and the step after
/// begins with it. So one pass over the wheels is enough while h^2 k w is 2 at most, for springs of
/// k and an inverse mass of w; stiffer ones rattle, and eight passes still them. Without the force
/// of the last step the car stands aslant.
///
/// What the ray sees at the start of a step counts for all of it. So a bump that is passed within a
/// frame or two throws the car several times too high or not at all, by where the step begins:
/// smooth the road that the rays see, or take substeps.
///
/// A damper that is stronger where it pulls than where it is pressed is a Suspension for each,
/// chosen by the sign of the speed. Strong dampers take their time, as in a car: with d on a spring
/// of k, d/k seconds until a third of the way is left. The wheel has no mass, and so none of its
/// hopping.
///
/// The tyres' grip, a push against the slip of each foot, of up to a share of that force, along the
/// car where it brakes and across it always. Here a car of two wheels, parked on a slope:
/// @code
/// const double h = 1 / 60.0, down = 9.81 * 0.2, most = 0.8 * 1200 * 9.6 / 2;
/// double v = 0, grip[] = {0, 0};
/// for (int n = 0; n < 600; ++n) {
///   v = v + h * down;
///   for (int i = 0; i < 2; ++i) v = v + h * grip[i] / 1200;  // what it held in the last step
///   for (int pass = 0; pass < 8; ++pass) {
///     for (int i = 0; i < 2; ++i) v = v + shelf::wheel_grip(grip[i], v, 1 / 1200.0, most, h) /
///     1200;
///   }
/// }
/// // Now v is 0.
/// // Now grip[0] + grip[1] is -2354.4.
/// @endcode
/// Where a tyre holds both ways, the two share its bound: `most` for one, and the root of what is
/// left of its square for the other. Grips help each other, and so they take some passes, eight in
/// most cars, each with the slip that the pushes so far have left. A wheel that cancels the whole
/// slip by itself, once, and forgets it, is what makes a parked car shake.
///
/// Promises:
/// - a wheel alone under a mass makes the step of backward Euler, to 8 roundings, for h omega from
///   10^-6 to 10^3
/// - the car above stands where four springs carry it, to 1e-12 m, after ten seconds at 15, 30, 60
///   and 240 Hz
/// - on the way there it is at 60 Hz never more than 1.3 cm from a run in steps of 1/60000 s, and
///   never more than 5.0 cm at 15 Hz
/// - with dampers of 300 kN s/m it is never more than 8 cm off, at any of these rates; with forces
///   of the start of the step it is thrown more than 60 m up within ten seconds, from 15 to 240 Hz
/// - no wheel pulls at the ground
/// - parked on a slope of 0.3 rad with a grip of 0.8 of the force and eight passes, it creeps by
///   less than 1e-9 m in a minute, at 15 to 240 Hz
/// - on a slope of 0.9 rad it slides with g (sin - 0.8 cos), to 1e-3 of it
#pragma once
#include <type_traits>

namespace shelf {

/// What stands between a wheel and the chassis.
template <class Real>
struct Suspension {
  Real stiffness;  ///< of the spring; not negative [N/m]
  Real damping;    ///< of the damper; not negative [N s/m]
};

/// The push of one wheel, after those that were handed on from the last step.
///
/// Backward Euler of spring and damper: the force is that at the end of the step, with the mass
/// that the wheel feels. Where it has been called for all wheels, it may be called for all of them
/// again, which brings the last bit of harmony between them.
///
/// @param force  with which the wheel carries the car: handed on from the last step, and given to
/// the car as a push of h times it before the first call; changed in place, 0 in the air [N]
/// @param compression  how much shorter the ray is than the strut and the wheel [m]; not above 0:
/// in the air
/// @param speed  of the mount away from the ground, with all pushes so far [m/s]
/// @param inverse_mass  that is felt at the mount [1/kg]; not negative
/// @param suspension  spring and damper
/// @param h  step size [s]; above 0
/// @returns  by how much the push changes, for you to give it to the car at once [N s]
/// @see E. Catto, Soft constraints, Game Developers Conference (2011)
template <class Real>
constexpr Real wheel_push(Real& force, Real compression, Real speed, Real inverse_mass,
                          const Suspension<Real>& suspension, Real h) {
  static_assert(!std::is_integral_v<Real>, "force and h must be no integers");
  // [wheel]
  const Real before = force;
  const Real resists = suspension.damping + h * suspension.stiffness;
  const Real asks = suspension.stiffness * compression - resists * speed;
  const Real next = force + (asks - force) / (Real(1) + h * resists * inverse_mass);
  force = compression > Real(0) && next > Real(0) ? next : Real(0);
  return h * (force - before);
  // [wheel]
}

/// The grip of one tyre in one direction along the ground, after what was handed on.
///
/// Takes the slip away, as far as the grip so far, this pass's with it, stays within its bound.
///
/// @param force  with which the tyre holds: handed on from the last step, and given to the car as a
/// push of h times it before the first pass; changed in place, 0 for a wheel in the air [N]
/// @param slip  speed of the foot over the ground in that direction, with all pushes so far [m/s]
/// @param inverse_mass  that is felt at the foot in that direction [1/kg]; not negative
/// @param most  the most that it can hold with: a share of the force of wheel_push [N]
/// @param h  step size [s]; above 0
/// @returns  by how much the push along the direction changes, for you to give to the car at once,
/// at the foot [N s]
template <class Real>
constexpr Real wheel_grip(Real& force, Real slip, Real inverse_mass, Real most, Real h) {
  static_assert(!std::is_integral_v<Real>, "force and h must be no integers");
  // [grip]
  const Real before = force;
  if (inverse_mass > Real(0)) force = force - slip / (h * inverse_mass);
  if (!(force < most)) force = most;
  if (!(force > -most)) force = -most;
  return h * (force - before);
  // [grip]
}

}  // namespace shelf
