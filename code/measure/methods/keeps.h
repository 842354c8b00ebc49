// SPDX-License-Identifier: MIT-0
/// @file
/// The common parts of methods that keep more than position and velocity.
///
/// Each says how its memory begins, how a step changes it, and which state it stands for. The rest
/// is what run() does.
#pragma once
#include <array>

#include "integrate/bdf2.h"
#include "integrate/velocity_verlet.h"
#include "scenes/state.h"

namespace measure {

/// The position and velocity of a memory.
template <class Memory>
using StateOf = scenes::State<typename Memory::value_type>;

/// The common part of methods that keep the acceleration.
struct KeepsAcceleration {
  /// The memory at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 3> start(const scenes::State<Vec>& s, Real, const Scene& scene) {
    return {s.x, s.v, integrate::velocity_verlet_start(s.x, s.v, Real(0), scene)};
  }
  /// The position and velocity that the memory stands for.
  template <class Memory, class Real, class Scene>
  static StateOf<Memory> to_state(const Memory& memory, Real, Real, const Scene&) {
    return {memory[0], memory[1]};
  }
};

/// The common part of both forms of BDF2: they keep the state of a step ago as well.
struct KeepsLastState {
  /// Besides the true 50, a quarter that its start moves too far.
  static constexpr double free_fall_after_ten_steps = 50.25 - 0.25 / 59049;

  /// The memory at the start.
  template <class Vec, class Real, class Scene>
  static std::array<Vec, 4> start(const scenes::State<Vec>& s, Real h, const Scene& scene) {
    const auto previous = integrate::bdf2_start(s.x, s.v, Real(0), h, scene);
    return {s.x, s.v, previous.x, previous.v};
  }
  /// The position and velocity that the memory stands for.
  template <class Memory, class Real, class Scene>
  static StateOf<Memory> to_state(const Memory& memory, Real, Real, const Scene&) {
    return {memory[0], memory[1]};
  }
};

}  // namespace measure
