// SPDX-License-Identifier: MIT-0
/// @file
/// A body that lands on several corners, slides, turns over and comes to rest: contacts with
/// friction.
///
/// A crate of 20 kg that falls onto a corner, in two dimensions. A complex number is a vector,
/// right and up:
/// @code
/// #include <complex>
/// using Flat = std::complex<double>;
/// const auto dot = [](Flat p, Flat q) { return p.real() * q.real() + p.imag() * q.imag(); };
/// struct {
///   double operator()(Flat r, Flat push) const { return (std::conj(r) * push).imag(); }
///   Flat operator()(double w, Flat r) const { return Flat(0, w) * r; }
/// } const cross;
/// const auto spin = [](double L) { return L / (20 * (0.8 * 0.8 + 0.6 * 0.6) / 12); };
/// const shelf::Surface<double> floor{0.5, 0.3, 0.5};  // friction, restitution, threshold
/// const Flat corners[] = {{0.4, 0.3}, {-0.4, 0.3}, {-0.4, -0.3}, {0.4, -0.3}};
/// shelf::Contact<Flat, double> contacts[4];
/// Flat x(0, 1), v = 0;
/// double angle = 0.5, L = 0;
/// for (int n = 0; n < 60 * 2; ++n) {
///   for (int i = 0; i < 4; ++i) {
///     contacts[i].r = std::polar(1.0, angle) * corners[i];
///     contacts[i].normal = Flat(0, 1);
///     contacts[i].gap = (x + contacts[i].r).imag();  // above a floor at a height of 0
///   }
///   const auto way = shelf::contact_step(v, L, Flat(0, -9.81), 1 / 60.0, contacts, 4, floor,
///                                        1 / 20.0, spin, dot, cross);
///   x = x + 1 / 60.0 * way.v;
///   angle = angle + 1 / 60.0 * spin(way.L);
/// }
/// // Now x.imag() is 0.3.
/// // Now angle is 0.
/// @endcode
///
/// The same in three dimensions, with the orientation of orientation.h, thrown along the floor:
/// @code
/// #include "orientation.h"
/// using Vec = shelf::Vec3<double>;
/// const Vec size{0.8, 0.6, 0.6}, inertia = shelf::inertia_of_box(20.0, size);
/// shelf::Quaternion<double> q;
/// shelf::turn_exact(q, {0.2, 1, 0.3}, 1);
/// Vec x{0, 1, 0}, v{3, 0, 0}, L;
/// const auto spin = [&](const Vec& momentum) { return angular_velocity(q, momentum, inertia); };
/// const auto dot_of = [](const Vec& p, const Vec& r) { return dot(p, r); };
/// const auto cross_of = [](const Vec& p, const Vec& r) { return cross(p, r); };
/// shelf::Contact<Vec, double> contacts[8];
/// for (int n = 0; n < 60 * 2; ++n) {
///   for (int i = 0; i < 8; ++i) {
///     const double side[] = {i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5};
///     contacts[i].r = rotate(q, {side[0] * size.x, side[1] * size.y, side[2] * size.z});
///     contacts[i].normal = {0, 1, 0};
///     contacts[i].gap = (x + contacts[i].r).y;
///   }
///   const auto way = shelf::contact_step(v, L, Vec{0, -9.81, 0}, 1 / 60.0, contacts, 8,
///                                        shelf::Surface<double>{0.5, 0.3, 0.5}, 1 / 20.0, spin,
///                                        dot_of, cross_of);
///   x = x + 1 / 60.0 * way.v;
///   spin_by_rotations(q, way.L, inertia, 1 / 60.0);
/// }
/// // Now x.x is 1.5554.
/// // Now x.y is 0.3.
/// // Now v.x is 0.
/// @endcode
///
/// A contact is a corner and what it may meet, and it keeps how hard it was pushed: the next step
/// begins with that, and so a thing at rest doesn't tremble. In a step each corner that touches is
/// pushed 16 times for the way and 16 times for the velocity at its end. Hand over the corners near
/// a floor, or all of them. On a floor that goes from p0 to p1 and from a velocity of u0 to
/// u1, hand over `v - u0`, `a - (u1 - u0) / h` and the gaps at the start. Then the place is
/// `x + (p1 - p0) + h * way.v`, and the velocity `v + u1`.
///
/// A ball is one corner, by its radius below its centre, which doesn't turn with it. It slides
/// until friction has made it roll, and then it rolls for ever: what brakes a rolling ball is drag
/// of your own. When two balls meet, see bounce.h.
///
/// It ends at one body on what doesn't give way. For stacks, joints, many bodies and what finds
/// their contacts take an engine: Box2D, Jolt, Rapier. A bounce begins at the end of the step in
/// which a corner meets the floor, with a share of the speed from that step's start; bounce.h has a
/// ball that bounces exactly when it is due. Within a step a corner is taken to go straight, so
/// what spins fast dips into the floor. More substeps help.
///
/// Promises:
/// - what touches nothing falls without error, to 10^-12 m in a second
/// - crates of 80 by 60 by 60 cm, let fall from half a metre with a friction of 0.5, tilted by
///   up to 0.3 rad about each axis and spinning by 1 rad/s, are at rest a second after they meet
///   the floor, with a restitution of 0 and of 0.3, at 30, 60, 120 and 240 Hz
/// - of those measured no corner is ever more than 1 mm within the floor
/// - of those measured the energy grows in no step by more than 10^-6 of all
/// - thrown so that it spins with up to 12 rad/s about each axis, none of a hundred dips into the
///   floor by more than 3 mm at 60 Hz, with a friction of up to 0.8
/// - thrown so, and with a restitution of up to 1, none of the hundred ever has 1 % of its first
///   energy more than it had before
/// - at rest it moves by less than 10^-12 m/s, and lies on the floor to 10^-12 m
/// - on a slope 0.01 rad below the angle of friction it creeps by less than 10^-6 m a minute
/// - 0.1 rad beyond that angle it slides with g (sin a - mu cos a), to 10^-10 of the way in two
///   seconds
/// - a box that spins flat on the floor is braked by its four corners for as long as the integral
///   over them says, to two steps
/// - a plate that slides and spins lies, at 60 Hz, within 2 cm of where steps of 1/20000 s over its
///   four corners take it, after up to 4.2 m
/// - a crate that topples over an edge is, at 60 Hz, within 0.02 rad of a pendulum upside down
/// - a ball that begins to slide rolls with 5/7 of its speed in the end, to 10^-12 of it, and comes
///   to that within a step of when it is due
#pragma once
#include <cmath>
#include <type_traits>

namespace shelf {

/// A corner of a body and what it may meet: a floor, a slope, a wall, each with its own normal.
///
/// Keep it from step to step, and write r, normal and gap before each. The rest is contact_step's;
/// of it push is 0 at first.
template <class Vec, class Real>
struct Contact {
  Vec r;               ///< from the centre of mass to the corner [m]
  Vec normal;          ///< away from what it may meet, of length 1
  Vec grip;            ///< what friction pushed in the last step, along the surface [kg m/s]
  Real gap = Real(0);  ///< how far the corner is from what it may meet; negative within it [m]

  Real push = Real(0);   ///< along the normal in the last step, as for a sound [kg m/s]
  Real mass = Real(0);   ///< that a push along the normal meets there; 0 if it takes no part [kg]
  Real least = Real(0);  ///< the speed along the normal that it has to have [m/s]
};

/// What it is like to touch.
template <class Real>
struct Surface {
  Real friction;     ///< coefficient of dry friction; not negative
  Real restitution;  ///< share of the speed that comes back, 0 to 1
  Real threshold;    ///< speed below which nothing comes back [m/s]
};

/// How a body moves in a step: with these to its end, and from there on with those it has then.
template <class Vec, class Turn>
struct Way {
  Vec v;   ///< velocity [m/s]
  Turn L;  ///< angular momentum [kg m^2/s]
};

/// A body while it is pushed at its contacts: what contact_step is made of.
template <class Vec, class Turn, class Real, class Spin, class Dot, class Cross>
struct PushedBody {
  Vec v;              ///< velocity [m/s]
  Turn L;             ///< angular momentum [kg m^2/s]
  Real inverse_mass;  ///< 1/mass [1/kg]
  Spin& spin;         ///< as contact_step has it
  Dot& dot;           ///< the dot product
  Cross& cross;       ///< the cross product
  using Corner = Contact<Vec, Real>;

  /// The velocity of a point of the body.
  /// @param r  from the centre of mass to it [m]
  Vec velocity_at(const Vec& r) const { return v + Vec(cross(spin(L), r)); }

  /// Pushes it there.
  /// @param r  from the centre of mass to it [m]
  /// @param J  the push [kg m/s]
  void push(const Vec& r, const Vec& J) {
    v = v + inverse_mass * J;
    L = L + Turn(cross(r, J));
  }

  /// How much faster, along the push, a point gets by a push of 1 [1/kg].
  /// @param r  from the centre of mass to it [m]
  /// @param n  direction of the push
  /// @param square  of the length of n
  Real inverse_mass_at(const Vec& r, const Vec& n, Real square) const {
    return inverse_mass + Real(dot(Vec(cross(spin(Turn(cross(r, n))), r)), n)) / square;
  }

  /// What both, the surface and its friction, push at a corner.
  /// @param corner  where
  static Vec push_at(const Corner& corner) { return corner.push * corner.normal + corner.grip; }

  /// Pushes a corner until it is as fast as it has to be and, if friction can do that, stands.
  /// @param corner  where; its pushes so far are added up, and only their sum has bounds
  /// @param friction  coefficient of dry friction
  void push_once(Corner& corner, Real friction) {
    const Vec& n = corner.normal;
    const Real before = corner.push;
    corner.push = before + corner.mass * (corner.least - Real(dot(velocity_at(corner.r), n)));
    if (!(corner.push > Real(0))) corner.push = Real(0);
    push(corner.r, (corner.push + Real(-1) * before) * n);
    if (!(before > Real(0)) && !(corner.push > Real(0))) return;

    const Vec slip = along(velocity_at(corner.r), n), grip = corner.grip;
    const Real square = dot(slip, slip);
    if (square > Real(0)) {
      corner.grip = grip + (Real(-1) / inverse_mass_at(corner.r, slip, square)) * slip;
    }
    const Real most = friction * corner.push,
               length = std::sqrt(Real(dot(corner.grip, corner.grip)));
    if (length > most) corner.grip = (most / length) * corner.grip;
    push(corner.r, corner.grip + Real(-1) * grip);
  }

  /// What of a vector is along a surface.
  /// @param y  vector
  /// @param n  normal of the surface
  Vec along(const Vec& y, const Vec& n) const { return y + Real(-Real(dot(y, n))) * n; }

  /// Pushes all corners as in the last step, but all of them by a share weaker or stronger, so that
  /// they are as fast as they have to be, on the whole.
  /// @param corners  where, with the pushes of the last step; with those of this one thereafter
  /// @param count  how many
  template <class Corners, class Count>
  void push_as_before(Corners& corners, Count count) {
    PushedBody pushed = *this;
    pushed.v = Real(0) * v;
    pushed.L = Real(0) * L;
    for (Count i = 0; i < count; ++i) {
      Corner& corner = corners[i];
      const Real slow = corner.least - Real(dot(velocity_at(corner.r), corner.normal));
      if (!(corner.push > Real(0)) && slow > Real(0)) corner.push = corner.mass * slow;
      pushed.push(corner.r, push_at(corner));
    }
    Real missing = Real(0), whole = Real(0);
    for (Count i = 0; i < count; ++i) {
      const Corner& corner = corners[i];
      const auto speed = [&](const PushedBody& body) {
        return Real(dot(body.velocity_at(corner.r), corner.normal));
      };
      missing = missing + corner.push * (corner.least - speed(*this));
      whole = whole + corner.push * speed(pushed);
    }
    const Real share = missing > Real(0) && whole > Real(0) ? missing / whole : Real(0);
    for (Count i = 0; i < count; ++i) {
      corners[i].push = share * corners[i].push;
      corners[i].grip = share * corners[i].grip;
    }
    v = v + share * pushed.v;
    L = L + share * pushed.L;
  }

  /// The energy that the pushes have given it [J].
  /// @param before  as it was without them
  /// @param corners  where they were
  /// @param count  how many
  template <class Corners, class Count>
  Real work_since(const PushedBody& before, const Corners& corners, Count count) const {
    Real work = Real(0);
    for (Count i = 0; i < count; ++i) {
      const Vec& r = corners[i].r;
      work =
          work + Real(dot(push_at(corners[i]), before.velocity_at(r) + velocity_at(r))) / Real(2);
    }
    return work;
  }
};

/// One step of a body that may touch something with several corners: it lands, bounces, slides,
/// turns over, rests.
///
/// Advances the velocity and the angular momentum, and tells by which others the body goes in this
/// step: `x = x + h * way.v`, and the orientation turns with way.L. What touches nothing falls
/// without error. Calls square roots.
///
/// @param v  velocity of the centre of mass, advanced in place [m/s]
/// @param L  angular momentum, advanced in place: a vector, or a number in two dimensions
/// [kg m^2/s]
/// @param a  acceleration throughout the step, of gravity as a rule [m/s^2]
/// @param h  step size [s]; not negative
/// @param contacts  `contacts[i]` is a Contact, of each corner that may touch something
/// @param count  how many
/// @param surface  what they are like to touch
/// @param inverse_mass  1/mass, above zero [1/kg]
/// @param spin  callable `(Turn) -> angular velocity`, of an angular momentum, as the body is
/// turned at the start
/// @param dot  callable `(Vec, Vec) -> Real`, the dot product
/// @param cross  callable `(Vec, Vec) -> Turn` and `(angular velocity, Vec) -> Vec`, the cross
/// product
/// @param sweeps  how often each corner is pushed
/// @returns  velocity and angular momentum for the way of this step
/// @see E. Catto, Iterative Dynamics with Temporal Coherence (2005)
template <class Vec, class Turn, class Contacts, class Count, class Real, class Spin, class Dot,
          class Cross>
Way<Vec, Turn> contact_step(Vec& v, Turn& L, const std::decay_t<Vec>& a, Real h,
                            Contacts&& contacts, Count count, const Surface<Real>& surface,
                            Real inverse_mass, Spin&& spin, Dot&& dot, Cross&& cross,
                            int sweeps = 16) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool dots = std::is_invocable_r_v<Real, Dot&, const Vec&, const Vec&>;
  constexpr bool crosses = std::is_invocable_r_v<Turn, Cross&, const Vec&, const Vec&>;
  constexpr bool spins = std::is_invocable_v<Spin&, const Turn&>;
  static_assert(scales,
                "h * v must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(dots, "dot must be callable as Real(Vec, Vec)");
  static_assert(crosses, "cross must be callable as Turn(Vec, Vec)");
  static_assert(spins, "spin must be callable as spin(L)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && dots && crosses && spins) {
    using Body = PushedBody<Vec, Turn, Real, std::remove_reference_t<Spin>,
                            std::remove_reference_t<Dot>, std::remove_reference_t<Cross>>;
    const Body start{v, L, inverse_mass, spin, dot, cross};
    if (!(h > Real(0))) return {v, L};
    const auto sweep = [&](Body& body) {
      for (int n = 0; n < sweeps; ++n) {
        for (Count i = 0; i < count; ++i) {
          if (contacts[i].mass > Real(0)) body.push_once(contacts[i], surface.friction);
        }
      }
    };
    // The way: no corner may go further than its gap.
    Body way = start;
    way.v = v + (h / Real(2)) * a;
    for (Count i = 0; i < count; ++i) {
      auto& corner = contacts[i];
      const Vec& n = corner.normal;
      corner.mass = Real(1) / start.inverse_mass_at(corner.r, n, Real(1));
      corner.least = -corner.gap / h;
      corner.grip = corner.push > Real(0) ? start.along(corner.grip, n) : Vec(Real(0) * n);
    }
    way.push_as_before(contacts, count);
    sweep(way);

    // The end: what was pushed on its way goes no further, or comes back.
    Body end = start;
    end.v = v + h * a;
    const Body free = end;
    bool bounces = false;
    for (Count i = 0; i < count; ++i) {
      auto& corner = contacts[i];
      const Real into = -Real(dot(start.velocity_at(corner.r), corner.normal));
      if (!(corner.push > Real(0))) corner.mass = Real(0);
      const bool comes_back = corner.mass > Real(0) && into > surface.threshold;
      corner.least = comes_back ? surface.restitution * into : Real(0);
      bounces = bounces || comes_back;
    }
    end.push_as_before(contacts, count);
    sweep(end);
    // Bounces of several corners with friction may add to the energy. Then they come back slower.
    const Vec lifted = way.v + Real(-1) * v + (h / Real(-2)) * a;
    const Real allowed = h / inverse_mass * Real(dot(a, lifted));
    for (int tries = 0; bounces && tries < 3 && !(end.work_since(free, contacts, count) <= allowed);
         ++tries) {
      for (Count i = 0; i < count; ++i) {
        contacts[i].least = tries < 2 ? contacts[i].least / Real(2) : Real(0);
      }
      sweep(end);
    }
    v = end.v;
    L = end.L;
    return {way.v, way.L};
  }
}

}  // namespace shelf
