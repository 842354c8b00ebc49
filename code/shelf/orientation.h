// SPDX-License-Identifier: MIT-0
/// @file
/// How a thing is turned, and how it tumbles: orientation, spin and angular momentum.
///
/// A book of a kilogram, thrown about its middle axis: after a second it spins on, upside down. The
/// orientation `q` and the angular momentum `L` are all that it has to remember. `L` is in the
/// world's axes and stays what it is until something pushes: `L = L + h * torque`. A torque that
/// brakes is no such push, since a long step would turn the spin round: see spin_damped, whose c is
/// then `-dot(torque, L) / dot(L, L)`; for a torque of -k |w| L, which goes with the square of the
/// spin, it is `std::log1p(h * k * |w|) / h`.
/// @code
/// const shelf::Vec3<double> inertia = shelf::inertia_of_box(1.0, {0.2, 0.14, 0.03});
/// shelf::Quaternion<double> q;
/// shelf::Vec3<double> L = shelf::angular_momentum(q, {0.2, 20, 0.2}, inertia);
/// for (int n = 0; n < 60; ++n) shelf::spin_by_rotations(q, L, inertia, 1 / 60.0);
/// const shelf::Vec3<double> spine = shelf::rotate(q, {0, 1, 0});
/// const shelf::Vec3<double> w = shelf::angular_velocity(q, L, inertia);
/// // Now spine.y is -0.9994.
/// // Now w.y is 19.998.
/// @endcode
///
/// A ship whose nose is steered, a quarter of a turn in a second:
/// @code
/// shelf::Quaternion<float> q;
/// for (int n = 0; n < 60; ++n) shelf::turn_exact(q, {0, 1.5707963f, 0}, 1 / 60.0f);
/// q = shelf::normalised(q);  // needed where one was blended or sent, and not here
/// const shelf::Vec3<float> nose = shelf::rotate(q, {0, 0, 1});
/// // Now nose.x is 1.0000.
/// @endcode
///
/// A turret that aims at what runs round it, at 0.5 rad/s:
/// @code
/// shelf::Quaternion<double> turret, aim;
/// shelf::Vec3<double> w;
/// for (int n = 0; n < 60; ++n) {
///   shelf::turn_exact(aim, {0, 0.5, 0}, 1 / 60.0);
///   shelf::turn_damp(turret, w, aim, {0, 0.5, 0}, 8, 1 / 60.0);
/// }
/// const double behind = shelf::turn_between(aim, turret).y;
/// // Now w.y is 0.50117.
/// // Now behind is 0.00017.
/// @endcode
///
/// A body that air slows down, and one beside it without air, slowed down by Bullet's step alone:
/// @code
/// const shelf::Vec3<double> inertia{1, 2, 3};
/// shelf::Quaternion<double> q, beside;
/// shelf::Vec3<double> L{0.2, 40, 0.6}, L_beside = L;
/// for (int n = 0; n < 60; ++n) {
///   shelf::spin_damped(q, L, inertia, 1 / 60.0, 0.2);
///   shelf::spin_by_bullet(beside, L_beside, inertia, 1 / 60.0);
/// }
/// // Now L.y is 32.749.
/// // Now L_beside.y is 33.479.
/// @endcode
///
/// A crate of 20 kg that lands on one of its corners and bounces, with half of the corner's speed;
/// for one that comes to rest on several see contact.h:
/// @code
/// const shelf::Vec3<double> inertia = shelf::inertia_of_box(20.0, {0.8, 0.6, 0.6});
/// const shelf::Vec3<double> up{0, 1, 0};
/// shelf::Quaternion<double> q;
/// shelf::turn_exact(q, {0.4, 0, 0.7}, 1);
/// shelf::Vec3<double> v{1, -4, 0}, L = shelf::angular_momentum(q, {0, 0, 2}, inertia);
/// const shelf::Vec3<double> r = shelf::rotate(q, {-0.4, -0.3, 0.3});  // the lowest corner
/// const auto rises = [&] {
///   return dot(v + cross(shelf::angular_velocity(q, L, inertia), r), up);
/// };
/// const double before = rises();
/// if (before < 0) {
///   const double heft = 1 / shelf::inverse_mass_at(q, inertia, 1 / 20.0, r, up);
///   const double J = (1 + 0.5) * -before * heft;
///   v = v + (J / 20) * up;
///   L = L + cross(r, J * up);
/// }
/// // Now before is -4.1589.
/// // Now rises() is 2.0794.
/// // Now v.y is 0.8494.
/// @endcode
///
/// The vectors and quaternions of your engine are copied in, turned and copied out, by their names,
/// since half of the libraries put `w` last: `shelf::Quaternion<float> q{r.w, r.x, r.y, r.z}`, and
/// back `r.w = q.w, r.x = q.x, r.y = q.y, r.z = q.z`. In a left-handed world the formulas are the
/// same. Sines and cosines, where one is called, are those of the C library: their last bit differs
/// from one machine to the next. `turn`, `spin_by_midpoint` and `inverse_mass_at` call none.
///
/// Promises:
/// - turn turns by 2*atan(h*|w|/2) instead of h*|w|: at 20 rad/s and 60 Hz it is 1.8 rad behind
///   after ten seconds
/// - turn_exact makes no error but rounding, from 1e-9 to 3 rad a step: 1e-12 rad in ten seconds
/// - the length of q stays one, to 1e-15, for 100000 steps
/// - a body with moments of 1, 2 and 3, thrown about its middle axis with 20 rad/s, has its energy
///   by rotations within 0.1 % at 60 Hz, for a hundred seconds
/// - that body is turned by rotations within 0.02 rad of the exact solution for a second at 60 Hz
/// - that body keeps its energy by the midpoint rule to 1e-13, for ten seconds at 60 Hz
/// - that body is turned by the midpoint rule within 0.22 rad of the exact solution for a second
/// - that body loses 88 % of its energy by Bullet's step in ten seconds at 60 Hz
/// - that body, turned by its angular velocity at the start of each step instead, has twice its
///   energy after ten seconds
/// - the rotations and the midpoint rule are of order 2
/// - by rotations a body with two equal moments is turned without error in steps of half a second:
///   1e-12 rad in ten seconds
/// - a step by -h takes back a step by h of the rotations and of the midpoint rule, to 1e-14 rad
/// - spin_damped leaves exp(-c*t) of L at any frame rate, and turns a body with two equal moments
///   without error: 1e-13 in two seconds at 1 to 240 Hz
/// - turn_damp about one axis ends where smooth_damp does, to 1e-13 rad in a second at 15 to 240
///   Hz, towards what turns evenly, too
/// - towards what rests it ends a second in the same place at 15, 30, 60, 120 and 240 Hz, to 1e-12
///   rad, whatever the axis of its spin
/// - it goes the shorter way round, from rest past no target, for turns of up to 3.1 rad
/// - a corner that is pushed with (1 + e) times its speed over inverse_mass_at leaves with e times
///   that speed, to 1e-14 of it
/// - such a push keeps the angular momentum about the corner, and with e = 1 the energy, to 1e-14
#pragma once
#include <cmath>
#include <type_traits>

namespace shelf {

/// Three numbers along x, y and z; the methods of this book take it, too.
template <class Real>
struct Vec3 {
  static_assert(!std::is_integral_v<Real>, "a vector must not be made of integers");
  using Number = Real;  ///< with Same, what lets 1 / 60.0 and `{0, 1, 0}` be arguments
  using Same = Vec3;    ///< a vector that fits
  Real x = 0, y = 0, z = 0;
};

/// The sum of two vectors.
template <class Real>
constexpr Vec3<Real> operator+(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// A vector s times as long.
template <class Real>
constexpr Vec3<Real> operator*(typename Vec3<Real>::Number s, const Vec3<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

/// The dot product.
template <class Real>
constexpr Real dot(const Vec3<Real>& a, const typename Vec3<Real>::Same& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The cross product: the speed of a point at r from the centre of a body that spins is
/// `cross(w, r)`.
template <class Real>
constexpr Vec3<Real> cross(const Vec3<Real>& a, const typename Vec3<Real>::Same& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// An orientation, from the body's axes to the world's; as it is made, not turned at all.
///
/// Its length is one, and every function below leaves it so. One that is zero has no direction:
/// turned, it is not a number.
template <class Real>
struct Quaternion {
  using Number = Real;     ///< with Vec, what lets `{0, 1, 0}` and 1 / 60.0 be arguments
  using Vec = Vec3<Real>;  ///< a vector that fits
  Real w = 1, x = 0, y = 0, z = 0;
};

/// The turn by b and after it the turn by a; or, in the body's axes, by a and after it by b.
template <class Real>
constexpr Quaternion<Real> operator*(const Quaternion<Real>& a, const Quaternion<Real>& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
      a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x,
  };
}

/// The same direction with length one.
template <class Real>
Quaternion<Real> normalised(const Quaternion<Real>& q) {
  const Real length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

/// A vector of the body, in the world's axes.
///
/// @param q  orientation, of length one
/// @param v  vector in the body's axes
template <class Real>
constexpr Vec3<Real> rotate(const Quaternion<Real>& q, const typename Quaternion<Real>::Vec& v) {
  const Vec3<Real> axis{q.x, q.y, q.z};
  const Vec3<Real> across = Real(2) * cross(axis, v);
  return v + q.w * across + cross(axis, across);
}

/// A vector of the world, in the body's axes.
///
/// @param q  orientation, of length one
/// @param v  vector in the world's axes
template <class Real>
constexpr Vec3<Real> rotate_back(const Quaternion<Real>& q,
                                 const typename Quaternion<Real>::Vec& v) {
  return rotate(Quaternion<Real>{q.w, -q.x, -q.y, -q.z}, v);
}

/// A turn to first order, as Rapier does it: a step of Euler's method, and back to length one.
///
/// It turns about the right axis, but by 2*atan(h*|w|/2) instead of h*|w|: too little, and never by
/// more than half a turn. No sine is called.
///
/// @param q  orientation, advanced in place
/// @param w  angular velocity in the world's axes [rad/s]
/// @param h  step size [s]; a negative step goes back
/// @see David Baraff, Physically Based Modeling: Rigid Body Simulation (2001), section 4
template <class Real>
void turn(Quaternion<Real>& q, const typename Quaternion<Real>::Vec& w,
          typename Quaternion<Real>::Number h) {
  const Vec3<Real> half = (h / Real(2)) * w;
  q = normalised(Quaternion<Real>{Real(1), half.x, half.y, half.z} * q);
}

/// A turn at a constant angular velocity, without error: the exponential map.
///
/// Calls a sine, a cosine and a square root. No turn is too slow for it.
///
/// @param q  orientation, advanced in place
/// @param w  angular velocity in the world's axes [rad/s]
/// @param h  step size [s]; a negative step goes back
/// @see F. S. Grassia, Practical Parameterization of Rotations Using the Exponential Map (1998)
template <class Real>
void turn_exact(Quaternion<Real>& q, const typename Quaternion<Real>::Vec& w,
                typename Quaternion<Real>::Number h) {
  const Vec3<Real> half = (h / Real(2)) * w;
  const Real angle = std::sqrt(dot(half, half));
  const Vec3<Real> by = (angle > Real(0) ? std::sin(angle) / angle : Real(1)) * half;
  q = normalised(Quaternion<Real>{std::cos(angle), by.x, by.y, by.z} * q);
}

/// The turn by which one orientation is ahead of another, the shorter way round: an axis in the
/// world's axes, as long as the angle [rad].
///
/// Calls an arc tangent and a square root.
///
/// @param q  orientation
/// @param from  the other one, both of length one
template <class Real>
Vec3<Real> turn_between(const Quaternion<Real>& q, const Quaternion<Real>& from) {
  const Quaternion<Real> by = q * Quaternion<Real>{from.w, -from.x, -from.y, -from.z};
  const Real side = by.w < Real(0) ? Real(-1) : Real(1);
  const Vec3<Real> half{side * by.x, side * by.y, side * by.z};
  const Real sine = std::sqrt(dot(half, half));
  return (sine > Real(0) ? Real(2) * std::atan2(sine, side * by.w) / sine : Real(2)) * half;
}

/// One step of a critically damped spring towards an orientation, the shorter way round: turrets,
/// heads, cameras, and what others call a PD controller.
///
/// Exact for any h where it all turns about one axis, as from rest it does; and towards what rests
/// it is the same at any frame rate, as long as it never gets half a turn away. About several axes
/// at once `w` is how fast the way that is left changes, which is the angular velocity once it has
/// come near. Calls sines, an arc tangent, exponentials and square roots.
///
/// It knows no top speed and no top torque: where it all turns about one axis, smooth_damp_limited
/// does, for the angle. What should swing on, as a tail or an ear, is no turn_damp: take a point at
/// its tip, move it by spring_exact to where it belongs, and turn the bone to look at it.
///
/// @param q  orientation of the follower, advanced in place
/// @param w  its angular velocity in the world's axes, advanced in place [rad/s]
/// @param target  how the target is turned at the end of the step
/// @param target_w  angular velocity with which it has come there; zero, if it rests [rad/s]
/// @param omega  how fast [rad/s]; not negative
/// @param h  step size [s]; finite, not negative
template <class Real>
void turn_damp(Quaternion<Real>& q, Vec3<Real>& w, const Quaternion<Real>& target,
               const typename Quaternion<Real>::Vec& target_w,
               typename Quaternion<Real>::Number omega, typename Quaternion<Real>::Number h) {
  // [turn-damp]
  Quaternion<Real> start = target;
  turn_exact(start, target_w, -h);
  const Vec3<Real> way = turn_between(q, start), speed = w + Real(-1) * target_w;
  const Real left = std::exp(-omega * h), lost = std::expm1(-omega * h);
  const Real pull = omega * h * left;
  q = target;
  turn_exact(q, (Real(1) + lost + pull) * way + (h * left) * speed, Real(1));
  w = w + ((lost - pull) * speed + (-omega * pull) * way);
  // [turn-damp]
}

/// The moments of inertia of a box about its own three axes [kg m^2].
///
/// @param mass  of the box, evenly spread [kg]
/// @param size  whole edges along x, y and z, not half of them [m]
template <class Real>
constexpr Vec3<Real> inertia_of_box(Real mass, const typename Quaternion<Real>::Vec& size) {
  const Real x = size.x * size.x, y = size.y * size.y, z = size.z * size.z;
  return (mass / Real(12)) * Vec3<Real>{y + z, x + z, x + y};
}

/// The angular momentum of a body that spins [kg m^2/s], in the world's axes.
///
/// @param q  orientation
/// @param w  angular velocity in the world's axes [rad/s]
/// @param inertia  moments about the body's own three axes [kg m^2]
template <class Real>
constexpr Vec3<Real> angular_momentum(const Quaternion<Real>& q,
                                      const typename Quaternion<Real>::Vec& w,
                                      const typename Quaternion<Real>::Vec& inertia) {
  const Vec3<Real> own = rotate_back(q, w);
  return rotate(q, {inertia.x * own.x, inertia.y * own.y, inertia.z * own.z});
}

/// How fast a body spins that has an angular momentum [rad/s], in the world's axes.
///
/// It is what a corner's speed follows from. It changes within a step, so don't turn a free body by
/// what it is at the start: that spins it up.
///
/// @param q  orientation
/// @param L  angular momentum in the world's axes [kg m^2/s]
/// @param inertia  moments about the body's own three axes, above zero [kg m^2]
template <class Real>
constexpr Vec3<Real> angular_velocity(const Quaternion<Real>& q,
                                      const typename Quaternion<Real>::Vec& L,
                                      const typename Quaternion<Real>::Vec& inertia) {
  const Vec3<Real> own = rotate_back(q, L);
  return rotate(q, {own.x / inertia.x, own.y / inertia.y, own.z / inertia.z});
}

/// What 1/mass is to a push at a corner, which turns the body as well [1/kg].
///
/// A push J along n, at r from the centre of mass, makes the corner faster along n by J times this.
/// For a corner that moves with `v + cross(w, r)` and meets the floor at a speed, against n:
/// `J = (1 + e) * speed / inverse_mass_at(q, inertia, 1 / mass, r, n)`, then
/// `v = v + (J / mass) * n` and `L = L + cross(r, J * n)`. Then it leaves with e times that speed.
/// Where two bodies meet, add up what both have there, and push them opposite ways. Friction is a
/// push, too, against the corner's slip.
///
/// @param q  orientation
/// @param inertia  moments about the body's own three axes, above zero [kg m^2]
/// @param inverse_mass  1/mass, zero or above [1/kg]
/// @param r  from the centre of mass to the corner, in the world's axes [m]
/// @param n  direction of the push, of length 1, in the world's axes
/// @see David Baraff, Physically Based Modeling: Rigid Body Simulation (2001), section 8
template <class Real>
constexpr Real inverse_mass_at(const Quaternion<Real>& q,
                               const typename Quaternion<Real>::Vec& inertia,
                               typename Quaternion<Real>::Number inverse_mass,
                               const typename Quaternion<Real>::Vec& r,
                               const typename Quaternion<Real>::Vec& n) {
  const Vec3<Real> turned = cross(r, n);
  return inverse_mass + dot(turned, angular_velocity(q, turned, inertia));
}

/// A step of a body that no torque acts on, by turns that are each exact.
///
/// Order 2, and stable for every h. First comes the turn that the body would make if each of its
/// moments were the middle one: as a ball, about L. What that leaves out are turns about the body's
/// own axes: about x and y for half the step, about z, and about y and x for the other half. A body
/// with two equal moments is turned without error. Calls up to six sines and six cosines.
///
/// @param q  orientation, advanced in place
/// @param L  angular momentum in the world's axes [kg m^2/s]; stays what it is
/// @param inertia  moments about the body's own three axes, above zero [kg m^2]
/// @param h  step size [s]; a negative step goes back
/// @see J. Touma and J. Wisdom, Lie-Poisson integrators for rigid body dynamics in the solar system
/// (1994)
template <class Real>
void spin_by_rotations(Quaternion<Real>& q, const typename Quaternion<Real>::Vec& L,
                       const typename Quaternion<Real>::Vec& inertia,
                       typename Quaternion<Real>::Number h) {
  // [rotations]
  const Vec3<Real> all{Real(1) / inertia.x, Real(1) / inertia.y, Real(1) / inertia.z};
  const Real less = all.x < all.y ? all.x : all.y, more = all.x < all.y ? all.y : all.x;
  const Real ball = all.z < less ? less : more < all.z ? more : all.z;
  const Vec3<Real> own = all + Real(-ball) * Vec3<Real>{Real(1), Real(1), Real(1)};
  Vec3<Real> spin = rotate_back(q, L);
  const auto about = [&](const Vec3<Real>& axis, Real time) {
    const Real half = time * dot(axis, spin) * dot(axis, own) / Real(2);
    const Vec3<Real> by = std::sin(half) * axis;
    const Quaternion<Real> turned{std::cos(half), by.x, by.y, by.z};
    q = q * turned;
    spin = rotate_back(turned, spin);
  };
  const Vec3<Real> x{Real(1)}, y{Real(0), Real(1)}, z{Real(0), Real(0), Real(1)};
  turn_exact(q, ball * L, h);
  about(x, h / Real(2));
  about(y, h / Real(2));
  about(z, h);
  about(y, h / Real(2));
  about(x, h / Real(2));
  q = normalised(q);
  // [rotations]
}

/// The same step with damping of the spin, L' = -c*L, which costs it no order and no accuracy.
///
/// A body that slows down runs through the orientations of one that does not, only later. Calls two
/// exponentials, too.
///
/// @param q  orientation, advanced in place
/// @param L  angular momentum in the world's axes [kg m^2/s], damped in place
/// @param inertia  moments about the body's own three axes, above zero [kg m^2]
/// @param h  step size [s]; a negative step goes back
/// @param c  damping [1/s]; in a second L becomes exp(-c) of what it was
template <class Real>
void spin_damped(Quaternion<Real>& q, typename Quaternion<Real>::Vec& L,
                 const typename Quaternion<Real>::Vec& inertia, typename Quaternion<Real>::Number h,
                 typename Quaternion<Real>::Number c) {
  spin_by_rotations(q, L, inertia, c * h == Real(0) ? h : -std::expm1(-c * h) / c);
  L = std::exp(-c * h) * L;
}

/// What backward Euler has to solve for a body without a torque: L = start + h * L x w.
template <class Real>
struct SpinEquation {
  Vec3<Real> start;    ///< angular momentum at the start, in the body's axes [kg m^2/s]
  Vec3<Real> inertia;  ///< moments about the body's own three axes, above zero [kg m^2]
  Real h;              ///< step size [s]

  /// One step of Newton's method.
  /// @param L  guess at the angular momentum at the end, in the body's axes
  /// @returns  a better one
  constexpr Vec3<Real> better(const Vec3<Real>& L) const {
    const Vec3<Real> w{L.x / inertia.x, L.y / inertia.y, L.z / inertia.z};
    const auto column = [&](const Vec3<Real>& axis, Real moment) {
      return axis + (-h) * (cross(axis, w) + (Real(1) / moment) * cross(L, axis));
    };
    const Vec3<Real> x = column({Real(1), Real(0), Real(0)}, inertia.x);
    const Vec3<Real> y = column({Real(0), Real(1), Real(0)}, inertia.y);
    const Vec3<Real> z = column({Real(0), Real(0), Real(1)}, inertia.z);
    const Vec3<Real> missing = start + Real(-1) * L + h * cross(L, w);
    const Vec3<Real> change{dot(missing, cross(y, z)), dot(missing, cross(z, x)),
                            dot(missing, cross(x, y))};
    return L + (Real(1) / dot(x, cross(y, z))) * change;
  }
};

/// A step of a body that no torque acts on, by the implicit midpoint rule.
///
/// Order 2. Keeps the energy while h*|w| is at most 2; above it Newton's method may lose its way,
/// and the energy with it. It is less accurate than spin_by_rotations, as it turns like `turn`. No
/// sine is called: the same bits everywhere.
///
/// @param q  orientation, advanced in place
/// @param L  angular momentum in the world's axes [kg m^2/s]; stays what it is
/// @param inertia  moments about the body's own three axes, above zero [kg m^2]
/// @param h  step size [s]; a negative step goes back
/// @see Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), section VII.5
template <class Real>
void spin_by_midpoint(Quaternion<Real>& q, const typename Quaternion<Real>::Vec& L,
                      const typename Quaternion<Real>::Vec& inertia,
                      typename Quaternion<Real>::Number h) {
  const Real half = h / Real(2);
  const SpinEquation<Real> to_middle{rotate_back(q, L), inertia, half};
  Vec3<Real> middle = to_middle.start;
  for (int n = 0; n < 6; ++n) middle = to_middle.better(middle);
  const Vec3<Real> by{half * middle.x / inertia.x, half * middle.y / inertia.y,
                      half * middle.z / inertia.z};
  q = normalised(q * Quaternion<Real>{Real(1), by.x, by.y, by.z});
}

/// A step of a body that no torque acts on, as Bullet takes it: to compare with, since it brakes.
///
/// One step of Newton's method towards backward Euler, and a turn by the spin that comes out.
/// Order 1. Bullet's own turn ends at an eighth of a turn in a step; here it doesn't.
///
/// @param q  orientation, advanced in place
/// @param L  angular momentum in the world's axes [kg m^2/s], which it changes
/// @param inertia  moments about the body's own three axes, above zero [kg m^2]
/// @param h  step size [s]
/// @see btRigidBody::computeGyroscopicImpulseImplicit_Body, after Erin Catto, Numerical Methods
/// (2015)
template <class Real>
void spin_by_bullet(Quaternion<Real>& q, typename Quaternion<Real>::Vec& L,
                    const typename Quaternion<Real>::Vec& inertia,
                    typename Quaternion<Real>::Number h) {
  const Vec3<Real> start = rotate_back(q, L);
  const Vec3<Real> end = SpinEquation<Real>{start, inertia, h}.better(start);
  turn_exact(q, rotate(q, {end.x / inertia.x, end.y / inertia.y, end.z / inertia.z}), h);
  L = rotate(q, end);
}

}  // namespace shelf
