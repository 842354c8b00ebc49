// SPDX-License-Identifier: MIT-0
/// @file
/// A link that keeps two points at a distance, stiff or springy, and a rope of such links.
///
/// @code
/// // A rope of two metres, held at its first point, with half a kilogram at its last.
/// const int count = 21;
/// double x[count], before[count], tension[count - 1], w[count];
/// for (int i = 0; i < count; ++i) x[i] = before[i] = -0.1 * i, w[i] = 1 / 0.01;
/// w[0] = 0, w[count - 1] = 1 / 0.5;
/// const auto norm = [](double d) { return d < 0 ? -d : d; };
/// const auto floor = [](double place) { return place < -2.5 ? -2.5 : place; };
/// const shelf::Rope<double> rope{0.1, 1 / 2000.0};  // links of 0.1 m, 2000 N/m
/// const double h = 1 / 960.0;                       // a substep: 16 in each frame
/// for (int n = 0; n < 60 * 60; ++n) {
///   for (int substep = 0; substep < 16; ++substep) {
///     shelf::rope_step(x, before, tension, w, count, rope, -9.81, h, norm, floor);
///   }
/// }
/// // Now x[20] is -2.070.
/// before[20] = before[20] - h * 3;                // a kick of 3 m/s upwards
/// const double speed = (x[20] - before[20]) / h;  // with the 0.008 of its bobbing
/// // Now speed is 3.008.
/// @endcode
///
/// Of these 7 cm its links give 5.8, as springs would, and the substeps 1.2: see the promises.
///
/// The velocity of a point is (x - before) / h: h is the substep, and `before` the place one
/// substep ago. A kick by dv is `before[i] = before[i] + (-h) * dv`. To blend fixed steps for the
/// screen, keep a copy of x from before the whole step; `before` is another thing.
///
/// No damping is built in. Of a bobbing the links take little: in its eleventh second the rope
/// above still bobs by 6.4 cm. Of a swing they take more, and the more the longer the step: see the
/// promises. For a player on one rope, take grapple.h, which takes nothing; for two bodies on a
/// link 4 substeps or 8. Who takes hold of a rope hands over his velocity, and has it back when he
/// lets go: `before = x + (-h) * v`. To reel in, make `length` a little shorter in each step.
///
/// To slow each point as exp(-c t) does, do this before each substep, with c h well below 1:
/// `before[i] = before[i] + (c * h) * (x[i] - before[i])`.
///
/// In float keep the places near the origin, as by counting them from the hook, or take double.
/// What a substep adds to a place, h^2 a, is rounded as the place is, and so gravity is wrong by a
/// share of up to |x| / (2^24 h^2 |a|). The more substeps, the worse: at 60 frames a second that is
/// 1 % at 29 m with 4 substeps, at 1.8 m with 16, and at 45 cm with 32. Beyond 2^25 h^2 |a|, 360 m
/// with 16 substeps, gravity is gone.
///
/// A sheet of cloth is made of the same links. If it has diagonals, don't take them in the order in
/// which it was made, cell by cell: what rounding leaves over grows from one link to the next, and
/// a wide sheet bursts in free fall. One of 64 by 32 cells does in float, and in double as soon as
/// it is a little out of shape. Shuffle the links once, always alike, or go twice over them.
///
/// One link: a dog of 20 kg, 2.2 m from a post, on a leash of 2 m that gives by 1 cm for 100 N;
/// the same again, begun with the tension that it had; and with a chain for a leash.
/// @code
/// const auto norm = [](double d) { return d < 0 ? -d : d; };
/// double post = 0, dog = 2.2, tension = 0;
/// shelf::link(post, dog, tension, 0.0, 1 / 20.0, 2.0, 1e-4, 1 / 60.0, norm);
/// // Now dog is 2.17561.
/// dog = 2.2;
/// shelf::link_warm_start(post, dog, tension, 0.0, 1 / 20.0, 1 / 60.0, norm);
/// shelf::link(post, dog, tension, 0.0, 1 / 20.0, 2.0, 1e-4, 1 / 60.0, norm);
/// // Now dog is 2.17561.
/// // Now tension is 1756.1.
/// shelf::pull(post, dog, 0.0, 1 / 20.0, 2.0, norm);
/// // Now dog is 2.
/// @endcode
///
/// Promises:
/// - a pull brings two points of 1 g to 1 t to their distance, to 4 roundings
/// - their centre of mass stays, to 4 roundings, and a point of inverse mass 0 stays to the bit
/// - a link with compliance makes the step of backward Euler: a stretch e that grows by v becomes
///   (e + h v) / (1 + (h omega)^2), to 4 roundings, for h omega from 10^-6 to 10^3
/// - where a rope hangs, with one pass, each link is longer than its tension asks for: by h^2/m
///   times the tension of the link below it, m being the mass of the point between them; to 10^-9
///   m
/// - of two metres in 20 links that should give 1 %, one pass gives 26.9 % with one step in 1/60
///   s, 2.62 with 4 substeps, 1.40 with 8, 1.10 with 16 and 1.03 with 32
/// - begun warm, it gives 1.000 % with 8 substeps
/// - begun warm, with one pass, it comes to rest if k h^2/m is 0.8 and bursts if it is 1.5, k being
///   the stiffness of a link and m the mass of a point; begun cold, it comes to rest at 10^9
/// - in float, let go at up to 2^17 h^2 g from the origin, it falls as in double, to 1 %; let go
///   at 2^25 h^2 g, it does not fall
/// - a grapple, one link of 6 m let go at 1 rad, has 81 % of its energy in seconds 5 to 10 with one
///   step in 1/60 s, 95 with 4 substeps, 97 with 8 and 99 with 16
/// - a level sheet of 64 by 32 cells with diagonals, of floats, turned against the axes, in free
///   fall and of 10^5 N/m or more, has links of more than twice their length within a second if
///   they are taken cell by cell, in 1 to 32 substeps; shuffled once, none is off by 2*10^-5 of its
///   length in a second
/// - no free point is below the floor after a step
#pragma once
#include <type_traits>

namespace shelf {

/// Moves two points until they are at a distance, the lighter one further: Jakobsen's pull.
///
/// Momentum is kept. Where both are immovable, or at the same place, they stay there; so do points
/// so near that the square of their distance is zero (below 1e-23 m in float).
///
/// @param x1  place of the first point, moved in place [m]
/// @param x2  place of the second, moved in place [m]
/// @param w1  1/m of the first point [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
/// @param length  distance to keep [m]; not negative
/// @param norm  callable `(Vec) -> Real`, the length of a vector
/// @see T. Jakobsen, Advanced character physics, Game Developers Conference (2001)
template <class Vec, class Real, class Norm>
constexpr void pull(Vec& x1, Vec& x2, Real w1, Real w2, Real length, Norm&& norm) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(
      scales, "w1 * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "length must be no integer");
  if constexpr (scales && measures) {
    // [pull]
    const Vec apart = x2 + Real(-1) * x1;
    const Real distance = norm(apart), w = w1 + w2;
    if (!(w > Real(0)) || !(distance * distance > Real(0))) return;
    const Real excess = (distance - length) / distance;
    x1 = x1 + (w1 / w * excess) * apart;
    x2 = x2 + (-w2 / w * excess) * apart;
    // [pull]
  }
}

/// Moves two points by the tension of a link, before the links are solved: a warm start.
///
/// What it moves them by is a force of the last step. Among other links, solved with few passes, it
/// therefore bursts where springs do.
///
/// @param x1  place of the first point, moved in place [m]
/// @param x2  place of the second, moved in place [m]
/// @param tension  of the link in the last step [N]
/// @param w1  1/m of the first point [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
/// @param h  step size [s]
/// @param norm  callable `(Vec) -> Real`, the length of a vector
template <class Vec, class Real, class Norm>
constexpr void link_warm_start(Vec& x1, Vec& x2, Real tension, Real w1, Real w2, Real h,
                               Norm&& norm) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && measures) {
    const Vec apart = x2 + Real(-1) * x1;
    const Real distance = norm(apart);
    if (!(distance * distance > Real(0))) return;
    const Real move = h * h * tension / distance;
    x1 = x1 + (w1 * move) * apart;
    x2 = x2 + (-w2 * move) * apart;
  }
}

/// Moves two points towards the distance of a link that may give way: XPBD.
///
/// With a compliance of 0 it is pull. Else it ends where the tension is stretch over compliance, at
/// the end of the step: backward Euler of a spring. What it remembers is the tension in newtons,
/// not the multiplier of the paper, which is -h^2 times that and so wrong after a step of another
/// size. Where both are immovable, or as near as those that stay in pull, they stay there.
///
/// @param x1  place of the first point, moved in place [m]
/// @param x2  place of the second, moved in place [m]
/// @param tension  what the link has pulled with in this step so far; 0 at its start, or that of
/// the last step after link_warm_start; changed in place, negative if it pushes [N]
/// @param w1  1/m of the first point [1/kg]; 0 is immovable
/// @param w2  1/m of the second [1/kg]; 0 is immovable
/// @param length  distance to keep [m]; not negative
/// @param compliance  1 over the stiffness [m/N]; not negative, 0 gives nothing
/// @param h  step size, the substep if there are substeps [s]; above 0
/// @param norm  callable `(Vec) -> Real`, the length of a vector
/// @see M. Macklin, M. Müller and N. Chentanez, XPBD, Motion in Games (2016)
template <class Vec, class Real, class Norm>
constexpr void link(Vec& x1, Vec& x2, Real& tension, Real w1, Real w2, Real length, Real compliance,
                    Real h, Norm&& norm) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  static_assert(scales,
                "h * x must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && measures) {
    // [link]
    const Vec apart = x2 + Real(-1) * x1;
    const Real distance = norm(apart), w = w1 + w2;
    if (!(w > Real(0)) || !(distance * distance > Real(0))) return;
    const Real change = (distance - length - compliance * tension) / (h * h * w + compliance);
    const Real move = h * h * change / distance;
    tension = tension + change;
    x1 = x1 + (w1 * move) * apart;
    x2 = x2 + (-w2 * move) * apart;
    // [link]
  }
}

/// The parts of a rope, and how its links are solved. See rope_step.
template <class Real>
struct Rope {
  Real length;                ///< of each link [m]
  Real compliance = Real(0);  ///< of each link, 1 over its stiffness [m/N]
  int passes = 1;             ///< down the rope in each step; above 0
  /// Whether each step begins with the tension of the last. Only if h^2 / (m compliance) is below
  /// 0.8, m being the lightest mass: at 1.5 the rope bursts, to any length. That is 0.22 in the
  /// example above, and four times as much with substeps twice as long, as in frames of 1/30 s.
  bool warm = false;
};

/// One step of a rope: its points by position Verlet, then its links, one after the other.
///
/// For substeps call it more often with a smaller h, always the same: its stiffness is made of it,
/// and so are the velocities, which are the way from `before`. A point of inverse mass 0 stays;
/// move it yourself, by its place.
///
/// @param x  places of the points, anything with [], moved in place [m]
/// @param before  where they were one step ago, one substep if there are substeps; the same at the
/// start to start from rest; moved in place [m]
/// @param tension  of the links, one fewer, 0 at the start, of the type of h [N]
/// @param w  1/m of the points, of the type of h [1/kg]; 0 is immovable
/// @param count  how many points, of the type that [] takes
/// @param rope  its links and how they are solved
/// @param a  acceleration of the free points, of gravity as a rule [m/s^2]; with its
/// type, since braces alone have none
/// @param h  step size [s]; above 0
/// @param norm  callable `(Vec) -> Real`, the length of a vector
/// @param floor  callable `(Vec) -> Vec`, called with the place of each free point after each pass.
/// What it returns is the point's new place: the same if it is free to be there, the nearest one
/// outside if it is in the ground or in a peg that the rope hangs over
/// @see Müller, Heidelberger, Hennix and Ratcliff, Position based dynamics (2007)
/// @see M. Macklin and others, Small steps in physics simulation (2019)
template <class Places, class Tensions, class Masses, class Count, class Vec, class Real,
          class Norm, class Floor>
constexpr void rope_step(Places& x, Places& before, Tensions& tension, const Masses& w, Count count,
                         const Rope<Real>& rope, const Vec& a, Real h, Norm&& norm, Floor&& floor) {
  constexpr auto scale = [](auto s, const auto& y) -> decltype(s * y) { return s * y; };
  constexpr bool scales = std::is_invocable_r_v<Vec, decltype(scale), Real, Vec>;
  constexpr bool measures = std::is_invocable_r_v<Real, Norm&, const Vec&>;
  constexpr bool floors = std::is_invocable_r_v<Vec, Floor&, const Vec&>;
  constexpr bool places = std::is_same_v<std::decay_t<decltype(x[0])>, Vec>;
  constexpr bool reals = std::is_same_v<std::decay_t<decltype(w[0])>, Real> &&
                         std::is_same_v<std::decay_t<decltype(tension[0])>, Real>;
  static_assert(scales,
                "h * a must be a Vec: 1/60.0f for floats; copy Maps; raylib lacks float * Vector3");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(floors, "floor must be callable as Vec(Vec)");
  static_assert(places, "a must be a Vec as the places are");
  static_assert(reals, "w and tension must hold the type of h: all float, or all double");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && measures && floors && places && reals) {
    // [rope]
    for (Count i = 0; i < count; ++i) {
      const Vec here = x[i];
      if (w[i] > Real(0)) x[i] = here + (here + Real(-1) * before[i]) + (h * h) * a;
      before[i] = here;
    }
    for (Count i = 1; i < count; ++i) {
      if (rope.warm) {
        link_warm_start(x[i - 1], x[i], tension[i - 1], w[i - 1], w[i], h, norm);
      } else {
        tension[i - 1] = Real(0);
      }
    }
    for (int pass = 0; pass < rope.passes; ++pass) {
      for (Count i = 1; i < count; ++i) {
        link(x[i - 1], x[i], tension[i - 1], w[i - 1], w[i], rope.length, rope.compliance, h, norm);
      }
      for (Count i = 0; i < count; ++i) {
        if (w[i] > Real(0)) x[i] = floor(x[i]);
      }
    }
    // [rope]
  }
}

}  // namespace shelf
