// SPDX-License-Identifier: MIT-0
/// @file
/// The implicit methods, as objects that can be handed to run() and to the other measurements.
#pragma once
#include <array>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "integrate/backward_euler.h"
#include "integrate/bdf2.h"
#include "integrate/trapezoid.h"
#include "measure/length.h"
#include "measure/methods/keeps.h"
#include "measure/methods/traits.h"
#include "measure/solver_of.h"

namespace measure {

/// Says so when an implicit step did not succeed.
inline void require_solved(bool solved) {
  if (!solved) throw std::runtime_error("an implicit step could not be solved");
}

/// integrate::backward_euler on a scene with a `jacobian`.
struct BackwardEuler : Orders<1> {
  static constexpr std::string_view name = "backward Euler", function = "backward_euler",
                                    header = "backward_euler.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr int free_fall_after_ten_steps = 55;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = false, contender = true;
  static constexpr FigureStyle style{5, Dash::solid, 15, 0.6};

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    require_solved(integrate::backward_euler(x, v, t, h, scene, solver_of(scene)));
  }
};

/// integrate::backward_euler_newton on a scene with a `jacobian`; down to rounding.
struct BackwardEulerNewton : Orders<1> {
  static constexpr std::string_view name = "backward Euler, to the end",
                                    function = "backward_euler_newton", header = "backward_euler.h";
  static constexpr long evaluations = as_needed;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr int free_fall_after_ten_steps = 55;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = false, contender = false;

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    const auto size = [](const auto& y) { return decltype(h)(length(y)); };
    const auto tolerance = 512 * std::numeric_limits<decltype(h)>::epsilon() * (1 + size(v));
    require_solved(
        integrate::backward_euler_newton(x, v, t, h, scene, solver_of(scene), size, tolerance) > 0);
  }
};

/// integrate::trapezoid on a scene with a `jacobian`.
struct Trapezoid : Orders<2> {
  static constexpr std::string_view name = "trapezoid", function = "trapezoid",
                                    header = "trapezoid.h";
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{11, Dash::dashed, 14, 0.7};

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    require_solved(integrate::trapezoid(x, v, t, h, scene, solver_of(scene)));
  }
};

/// integrate::trapezoid_newton on a scene with a `jacobian`; down to rounding.
struct TrapezoidNewton : Orders<2> {
  static constexpr std::string_view name = "trapezoid, to the end", function = "trapezoid_newton",
                                    header = "trapezoid.h";
  static constexpr long evaluations = as_needed;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = true, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = false;

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    const auto size = [](const auto& y) { return decltype(h)(length(y)); };
    const auto tolerance = 512 * std::numeric_limits<decltype(h)>::epsilon() * (1 + size(v));
    require_solved(
        integrate::trapezoid_newton(x, v, t, h, scene, solver_of(scene), size, tolerance) > 0);
  }
};

/// integrate::bdf2 with equal steps on a scene with a `jacobian`: keeps the last state.
struct Bdf2 : Orders<2>, KeepsLastState {
  static constexpr std::string_view name = "BDF2", function = "bdf2", header = "bdf2.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = false, contender = true;
  static constexpr FigureStyle style{12, Dash::solid, 12, 0.8};

  /// One step, as long as the one before it.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::Bdf2Previous<typename Memory::value_type> previous{memory[2], memory[3]};
    require_solved(
        integrate::bdf2(memory[0], memory[1], previous, t, h, h, scene, solver_of(scene)));
    memory[2] = previous.x, memory[3] = previous.v;
  }
};

/// integrate::bdf2_newton with equal steps on a scene with a `jacobian`: keeps the last state; down
/// to rounding.
struct Bdf2Newton : Orders<2>, KeepsLastState {
  static constexpr std::string_view name = "BDF2, to the end", function = "bdf2_newton",
                                    header = "bdf2.h";
  static constexpr long evaluations = as_needed;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = false, contender = false;

  /// One step, as long as the one before it.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    const auto size = [](const auto& y) { return Real(length(y)); };
    const auto tolerance = 512 * std::numeric_limits<Real>::epsilon() * (1 + size(memory[1]));
    integrate::Bdf2Previous<typename Memory::value_type> previous{memory[2], memory[3]};
    require_solved(integrate::bdf2_newton(memory[0], memory[1], previous, t, h, h, scene,
                                          solver_of(scene), size, tolerance) > 0);
    memory[2] = previous.x, memory[3] = previous.v;
  }
};

inline constexpr BackwardEuler backward_euler;               ///< instance for generic code
inline constexpr BackwardEulerNewton backward_euler_newton;  ///< instance for generic code
inline constexpr Trapezoid trapezoid;                        ///< instance for generic code
inline constexpr TrapezoidNewton trapezoid_newton;           ///< instance for generic code
inline constexpr Bdf2 bdf2;                                  ///< instance for generic code
inline constexpr Bdf2Newton bdf2_newton;                     ///< instance for generic code

}  // namespace measure

namespace list {

/// Those that solve for the end of a step.
using ImplicitKin =
    std::tuple<measure::BackwardEuler, measure::BackwardEulerNewton, measure::Trapezoid,
               measure::TrapezoidNewton, measure::Bdf2, measure::Bdf2Newton>;

}  // namespace list
