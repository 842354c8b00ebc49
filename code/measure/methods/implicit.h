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
  static constexpr int free_fall = 55;
  static constexpr bool symplectic = false, reversible = false, central = false;
  static constexpr bool goes_back = false, contender = true;
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
  static constexpr int free_fall = 55;
  static constexpr bool symplectic = false, reversible = false, central = false;
  static constexpr bool goes_back = false, contender = false;

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
  static constexpr int free_fall = 50;
  static constexpr bool symplectic = false, reversible = false, central = false;
  static constexpr bool goes_back = true, contender = true;
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
  static constexpr int free_fall = 50;
  static constexpr bool symplectic = false, reversible = true, central = false;
  static constexpr bool goes_back = true, contender = false;

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
  static constexpr bool symplectic = false, reversible = false, central = false;
  static constexpr bool goes_back = false, contender = true;
  static constexpr FigureStyle style{12, Dash::solid, 12, 0.8};

  /// One step, as long as the one before it.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    integrate::Bdf2Previous<typename Kept::value_type> previous{kept[2], kept[3]};
    require_solved(integrate::bdf2(kept[0], kept[1], previous, t, h, h, scene, solver_of(scene)));
    kept[2] = previous.x, kept[3] = previous.v;
  }
};

/// integrate::bdf2_newton with equal steps on a scene with a `jacobian`: keeps the last state; down
/// to rounding.
struct Bdf2Newton : Orders<2>, KeepsLastState {
  static constexpr std::string_view name = "BDF2, to the end", function = "bdf2_newton",
                                    header = "bdf2.h";
  static constexpr long evaluations = as_needed;
  static constexpr double drag_limit = always, spring_limit = always;
  static constexpr bool symplectic = false, reversible = false, central = false;
  static constexpr bool goes_back = false, contender = false;

  /// One step, as long as the one before it.
  template <class Kept, class Real, class Scene>
  static void step(Kept& kept, Real t, Real h, const Scene& scene) {
    const auto size = [](const auto& y) { return Real(length(y)); };
    const auto tolerance = 512 * std::numeric_limits<Real>::epsilon() * (1 + size(kept[1]));
    integrate::Bdf2Previous<typename Kept::value_type> previous{kept[2], kept[3]};
    require_solved(integrate::bdf2_newton(kept[0], kept[1], previous, t, h, h, scene,
                                          solver_of(scene), size, tolerance) > 0);
    kept[2] = previous.x, kept[3] = previous.v;
  }
};

inline constexpr BackwardEuler backward_euler;               ///< to hand on
inline constexpr BackwardEulerNewton backward_euler_newton;  ///< to hand on
inline constexpr Trapezoid trapezoid;                        ///< to hand on
inline constexpr TrapezoidNewton trapezoid_newton;           ///< to hand on
inline constexpr Bdf2 bdf2;                                  ///< to hand on
inline constexpr Bdf2Newton bdf2_newton;                     ///< to hand on

}  // namespace measure

namespace list {

/// Those that solve for the end of a step.
using ImplicitKin =
    std::tuple<measure::BackwardEuler, measure::BackwardEulerNewton, measure::Trapezoid,
               measure::TrapezoidNewton, measure::Bdf2, measure::Bdf2Newton>;

}  // namespace list
