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
/// for (int n = 0; n < 60 * 60; ++n) {
///   for (int substep = 0; substep < 16; ++substep) {
///     shelf::rope_step(x, before, tension, w, count, rope, -9.81, 1 / 960.0, norm, floor);
///   }
/// }
/// // Now x[20] is -2.070.
/// @endcode
///
/// Of these 7 cm its links give 5.8, as springs would, and the substeps 1.2: see the promises.
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
/// - where a rope hangs, with one pass, each link is as long as its tension asks for and, by
///   h^2/m times the tension of the next link, longer, m being the mass between the two; to 10^-9
///   m
/// - of two metres in 20 links that should give 1 %, one pass gives 26.9 % with one step in 1/60
///   s, 2.62 with 4 substeps, 1.40 with 8, 1.10 with 16 and 1.03 with 32
/// - begun warm, it gives 1.000 % with 8 substeps
/// - begun warm, with one pass, it comes to rest at a stiffness of 0.8 m/h^2 and bursts at 1.5
///   m/h^2, as springs do; begun cold, it comes to rest at 10^9 m/h^2
/// - no free point is below the floor after a step
#pragma once
#include <type_traits>

namespace shelf {

/// Moves two points until they are at a distance, the lighter one further: Jakobsen's pull.
///
/// Momentum is kept. Where both are immovable, or at the same place, they stay there.
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
  static_assert(scales, "w1 * x must be a Vec");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "length must be no integer");
  if constexpr (scales && measures) {
    // [pull]
    const Vec apart = x2 + Real(-1) * x1;
    const Real distance = norm(apart), w = w1 + w2;
    if (!(w > Real(0)) || !(distance > Real(0))) return;
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
  static_assert(scales, "h * x must be a Vec");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && measures) {
    const Vec apart = x2 + Real(-1) * x1;
    const Real distance = norm(apart);
    if (!(distance > Real(0))) return;
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
/// size. Where both are immovable, or at the same place, they stay there.
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
  static_assert(scales, "h * x must be a Vec");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && measures) {
    // [link]
    const Vec apart = x2 + Real(-1) * x1;
    const Real distance = norm(apart), w = w1 + w2;
    if (!(w > Real(0)) || !(distance > Real(0))) return;
    const Real change = (distance - length - compliance * tension) / (h * h * w + compliance);
    const Real move = h * h * change / distance;
    tension = tension + change;
    x1 = x1 + (w1 * move) * apart;
    x2 = x2 + (-w2 * move) * apart;
    // [link]
  }
}

/// What a rope is made of, and how its links are solved. See rope_step.
template <class Real>
struct Rope {
  Real length;                ///< of each link [m]
  Real compliance = Real(0);  ///< of each link, 1 over its stiffness [m/N]
  int passes = 1;             ///< down the rope in each step; above 0
  bool warm = false;          ///< whether each step begins with the tension of the last
};

/// One step of a rope: its points by position Verlet, then its links, one after the other.
///
/// For substeps call it more often with a smaller h, always the same: its stiffness is made of it,
/// and so are the velocities, which are the way from `before`. A point of inverse mass 0 stays;
/// move it yourself, by its place.
///
/// @param x  places of the points, anything with [], moved in place [m]
/// @param before  where they were a step ago, the same at the start to start from rest; moved in
/// place [m]
/// @param tension  of the links, one fewer, 0 at the start [N]
/// @param w  1/m of the points [1/kg]; 0 is immovable
/// @param count  how many points, of the type that [] takes
/// @param rope  its links and how they are solved
/// @param a  acceleration of the free points, of gravity as a rule [m/s^2]
/// @param h  step size [s]; above 0
/// @param norm  callable `(Vec) -> Real`, the length of a vector
/// @param floor  callable `(Vec) -> Vec`: where a point may be that would be there. Called for each
/// free point after each pass; a floor, a peg to hang over, or what it got if there is none
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
  static_assert(scales, "h * a must be a Vec");
  static_assert(measures, "norm must be callable as Real(Vec)");
  static_assert(floors, "floor must be callable as Vec(Vec)");
  static_assert(places, "a must be a Vec as the places are");
  static_assert(!std::is_integral_v<Real>, "h must be no integer");
  if constexpr (scales && measures && floors && places) {
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
