// SPDX-License-Identifier: MIT-0
/// @file
/// The methods that keep more than position and velocity, as objects that can be handed on.
///
/// Each says how its memory begins, how a step changes it, and which state it stands for. The rest
/// is what run() does.
#pragma once
#include <array>

#include "integrate/dopri5.h"
#include "integrate/leapfrog.h"
#include "integrate/stormer_verlet.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "scenes/state.h"

namespace measure {

/// The state of a method that keeps these.
template <class Kept>
using StateOf = scenes::State<typename Kept::value_type>;

/// integrate::stormer_verlet: keeps two positions.
struct StormerVerlet {
  /// What it keeps at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    return {s.x, integrate::stormer_verlet_start(s.x, s.v, Real(0), h, scene)};
  }
  /// One step.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet(kept[0], kept[1], t, h, scene);
  }
  /// The state that it stands for, its velocity half a step late.
  template <class Kept, class Real, class Scene>
  static StateOf<Kept> seen(const Kept& kept, Real, Real h, const Scene&) {
    return {kept[0], integrate::stormer_verlet_velocity(kept[0], kept[1], h)};
  }
};

/// integrate::stormer_verlet_uneven with equal steps: keeps two positions.
struct StormerVerletUneven : StormerVerlet {
  /// One step, as long as the one before it.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet_uneven(kept[0], kept[1], t, h, h, scene);
  }
};

/// integrate::stormer_verlet_carried: keeps two positions and the acceleration.
struct StormerVerletCarried {
  /// What it keeps at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 3> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    const Vec a = scene(s.x, s.v, Real(0));
    return {s.x, integrate::stormer_verlet_start(s.x, s.v, Real(0), h, scene), a};
  }
  /// One step.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet_carried(kept[0], kept[1], kept[2], t, h, scene);
  }
  /// The state that it stands for, its velocity brought up to date.
  template <class Kept, class Real, class Scene>
  static StateOf<Kept> seen(const Kept& kept, Real, Real h, const Scene&) {
    return {kept[0], integrate::stormer_verlet_carried_velocity(kept[0], kept[1], kept[2], h)};
  }
};

/// integrate::leapfrog: keeps the velocity of half a step ago.
struct Leapfrog {
  /// What it keeps at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    return {s.x, integrate::leapfrog_start(s.x, s.v, Real(0), h, scene)};
  }
  /// One step.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::leapfrog(kept[0], kept[1], t, h, scene);
  }
  /// The state that it stands for; asks for the acceleration to bring the velocity up to date.
  template <class Kept, class Real, class Scene>
  static StateOf<Kept> seen(const Kept& kept, Real t, Real h, const Scene& scene) {
    return {kept[0], integrate::leapfrog_velocity(kept[0], kept[1], t, h, scene)};
  }
};

/// What the methods have in common that keep the acceleration.
struct KeepsAcceleration {
  /// What is kept at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 3> start(const scenes::State<Vec>& s, Real, const Scene& scene) {
    return {s.x, s.v, integrate::velocity_verlet_start(s.x, s.v, Real(0), scene)};
  }
  /// The state that it stands for.
  template <class Kept, class Real, class Scene>
  static StateOf<Kept> seen(const Kept& kept, Real, Real, const Scene&) {
    return {kept[0], kept[1]};
  }
};

/// integrate::velocity_verlet: keeps the acceleration.
struct VelocityVerlet : KeepsAcceleration {
  /// One step.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::velocity_verlet(kept[0], kept[1], kept[2], t, h, scene);
  }
};

/// integrate::yoshida4: keeps the acceleration.
struct Yoshida4 : KeepsAcceleration {
  /// One step.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::yoshida4(kept[0], kept[1], kept[2], t, h, scene);
  }
};

/// integrate::dopri5 with equal steps: keeps the acceleration.
struct Dopri5 : KeepsAcceleration {
  /// One step.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::dopri5(kept[0], kept[1], kept[2], t, h, scene);
  }
};

inline constexpr StormerVerlet stormer_verlet;                 ///< to hand on
inline constexpr StormerVerletUneven stormer_verlet_uneven;    ///< to hand on
inline constexpr StormerVerletCarried stormer_verlet_carried;  ///< to hand on
inline constexpr Leapfrog leapfrog;                            ///< to hand on
inline constexpr VelocityVerlet velocity_verlet;               ///< to hand on
inline constexpr Yoshida4 yoshida4;                            ///< to hand on
inline constexpr Dopri5 dopri5;                                ///< to hand on

}  // namespace measure
