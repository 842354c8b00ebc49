// SPDX-License-Identifier: MIT-0
/// @file
/// The implicit methods as objects that can be handed on, for a page, which has no exceptions.
#pragma once
#include <limits>

#include "integrate/backward_euler.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "measure/methods/keeps.h"
#include "measure/solver_of.h"

namespace live {

/// integrate::backward_euler on a scene with a `jacobian`; not a number where it has no solution.
inline constexpr auto backward_euler = [](auto& x, auto& v, auto t, auto h, const auto& scene) {
  const bool solved = integrate::backward_euler(x, v, t, h, scene, measure::solver_of(scene));
  if (!solved) x = std::numeric_limits<double>::quiet_NaN() * x;
};

/// integrate::trapezoid on a scene with a `jacobian`; not a number where it has no solution.
inline constexpr auto trapezoid = [](auto& x, auto& v, auto t, auto h, const auto& scene) {
  const bool solved = integrate::trapezoid(x, v, t, h, scene, measure::solver_of(scene));
  if (!solved) x = std::numeric_limits<double>::quiet_NaN() * x;
};

/// integrate::bdf2 with equal steps on a scene with a `jacobian`; not a number where it has no
/// solution.
struct Bdf2 : measure::KeepsLastState {
  /// One step, as long as the one before it.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::Bdf2Previous<typename Memory::value_type> previous{memory[2], memory[3]};
    const bool solved =
        integrate::bdf2(memory[0], memory[1], previous, t, h, h, scene, measure::solver_of(scene));
    if (!solved) memory[0] = std::numeric_limits<double>::quiet_NaN() * memory[0];
    memory[2] = previous.x, memory[3] = previous.v;
  }
};

inline constexpr Bdf2 bdf2;  ///< instance for generic code

}  // namespace live
