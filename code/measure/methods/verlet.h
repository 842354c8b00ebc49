// SPDX-License-Identifier: MIT-0
/// @file
/// Verlet’s methods and Yoshida’s, as objects that can be handed to run() and to the other
/// measurements.
#pragma once
#include <array>
#include <string_view>
#include <tuple>

#include "integrate/leapfrog.h"
#include "integrate/leapfrog_drift.h"
#include "integrate/stormer_verlet.h"
#include "integrate/velocity_verlet.h"
#include "integrate/yoshida4.h"
#include "measure/methods/keeps.h"
#include "measure/methods/traits.h"
#include "scenes/state.h"

namespace measure {

/// The common part of the forms of position Verlet that keep two positions.
struct KeepsTwoPositions {
  /// The memory at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    return {s.x, integrate::stormer_verlet_start(s.x, s.v, Real(0), h, scene)};
  }
  /// The state that it stands for, its velocity half a step late.
  template <class Memory, class Real, class Scene>
  static StateOf<Memory> to_state(const Memory& memory, Real, Real h, const Scene&) {
    return {memory[0], integrate::stormer_verlet_velocity(memory[0], memory[1], h)};
  }
};

/// integrate::leapfrog: keeps the velocity of half a step ago.
struct Leapfrog : Orders<2, 2, 1> {
  static constexpr std::string_view name = "leapfrog", function = "leapfrog", header = "leapfrog.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{3, Dash::dotted, 1, 0.8};

  /// The memory at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    return {s.x, integrate::leapfrog_start(s.x, s.v, Real(0), h, scene)};
  }
  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::leapfrog(memory[0], memory[1], t, h, scene);
  }
  /// The state that it stands for; asks for the acceleration to bring the velocity up to date.
  template <class Memory, class Real, class Scene>
  static StateOf<Memory> to_state(const Memory& memory, Real t, Real h, const Scene& scene) {
    return {memory[0], integrate::leapfrog_velocity(memory[0], memory[1], t, h, scene)};
  }
};

/// integrate::leapfrog_drift.
struct LeapfrogDrift : Orders<2, 2, 1> {
  static constexpr std::string_view name = "drift, kick, drift", function = "leapfrog_drift",
                                    header = "leapfrog_drift.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = false;

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::leapfrog_drift(x, v, t, h, acceleration);
  }
};

/// integrate::stormer_verlet: keeps two positions.
struct StormerVerlet : Orders<2, 1>, KeepsTwoPositions {
  static constexpr std::string_view name = "Störmer–Verlet", function = "stormer_verlet",
                                    header = "stormer_verlet.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{3, Dash::dashed, 8, 0.8};

  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet(memory[0], memory[1], t, h, scene);
  }
};

/// integrate::stormer_verlet_carried: keeps two positions and the acceleration.
struct StormerVerletCarried : Orders<2> {
  static constexpr std::string_view name = "Störmer–Verlet, carried",
                                    function = "stormer_verlet_carried",
                                    header = "stormer_verlet.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 1, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = false;

  /// The memory at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 3> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    const Vec a = scene(s.x, s.v, Real(0));
    return {s.x, integrate::stormer_verlet_start(s.x, s.v, Real(0), h, scene), a};
  }
  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet_carried(memory[0], memory[1], memory[2], t, h, scene);
  }
  /// The state that it stands for, its velocity brought up to date.
  template <class Memory, class Real, class Scene>
  static StateOf<Memory> to_state(const Memory& memory, Real, Real h, const Scene&) {
    return {memory[0],
            integrate::stormer_verlet_carried_velocity(memory[0], memory[1], memory[2], h)};
  }
};

/// integrate::stormer_verlet_distance: keeps a position and the last distance.
struct StormerVerletDistance : Orders<2, 1> {
  static constexpr std::string_view name = "Störmer–Verlet, by distance",
                                    function = "stormer_verlet_distance",
                                    header = "stormer_verlet.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = false;

  /// The memory at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 2> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    return {s.x, integrate::stormer_verlet_distance_start(s.x, s.v, Real(0), h, scene)};
  }
  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet_distance(memory[0], memory[1], t, h, scene);
  }
  /// The state that it stands for, its velocity half a step late.
  template <class Memory, class Real, class Scene>
  static StateOf<Memory> to_state(const Memory& memory, Real, Real h, const Scene&) {
    return {memory[0], (Real(1) / h) * memory[1]};
  }
};

/// integrate::stormer_verlet_uneven with equal steps: keeps two positions.
struct StormerVerletUneven : Orders<2, 1>, KeepsTwoPositions {
  static constexpr std::string_view name = "Störmer–Verlet, uneven",
                                    function = "stormer_verlet_uneven", header = "stormer_verlet.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = false;

  /// One step, as long as the one before it.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::stormer_verlet_uneven(memory[0], memory[1], t, h, h, scene);
  }
};

/// integrate::velocity_verlet: keeps the acceleration.
struct VelocityVerlet : Orders<2>, KeepsAcceleration {
  static constexpr std::string_view name = "velocity Verlet", function = "velocity_verlet",
                                    header = "velocity_verlet.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 1, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{3, Dash::solid, 9, 0.7};

  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::velocity_verlet(memory[0], memory[1], memory[2], t, h, scene);
  }
};

/// integrate::yoshida4: keeps the acceleration.
struct Yoshida4 : Orders<4, 4, 2>, KeepsAcceleration {
  static constexpr std::string_view name = "Yoshida 4", function = "yoshida4",
                                    header = "yoshida4.h";
  static constexpr long evaluations = 3;
  static constexpr double drag_limit = 0.912983, spring_limit = 1.573401;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = true, reversible = true, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{10, Dash::solid, 2, 0.8};

  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::yoshida4(memory[0], memory[1], memory[2], t, h, scene);
  }
};

inline constexpr Leapfrog leapfrog;                              ///< instance for generic code
inline constexpr LeapfrogDrift leapfrog_drift;                   ///< instance for generic code
inline constexpr StormerVerlet stormer_verlet;                   ///< instance for generic code
inline constexpr StormerVerletCarried stormer_verlet_carried;    ///< instance for generic code
inline constexpr StormerVerletDistance stormer_verlet_distance;  ///< instance for generic code
inline constexpr StormerVerletUneven stormer_verlet_uneven;      ///< instance for generic code
inline constexpr VelocityVerlet velocity_verlet;                 ///< instance for generic code
inline constexpr Yoshida4 yoshida4;                              ///< instance for generic code

}  // namespace measure

namespace list {

/// Verlet’s methods and those made of them.
using VerletFamily =
    std::tuple<measure::Leapfrog, measure::LeapfrogDrift, measure::StormerVerlet,
               measure::StormerVerletCarried, measure::StormerVerletDistance,
               measure::StormerVerletUneven, measure::VelocityVerlet, measure::Yoshida4>;

}  // namespace list
