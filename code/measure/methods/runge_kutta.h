// SPDX-License-Identifier: MIT-0
/// @file
/// The Runge-Kutta methods, as objects that can be handed to run() and to the other measurements.
#pragma once
#include <string_view>
#include <tuple>

#include "integrate/dopri5.h"
#include "integrate/heun.h"
#include "integrate/midpoint.h"
#include "integrate/predicted_euler.h"
#include "integrate/rk4.h"
#include "measure/methods/keeps.h"
#include "measure/methods/traits.h"

namespace measure {

/// integrate::midpoint.
struct Midpoint : Orders<2> {
  static constexpr std::string_view name = "midpoint", function = "midpoint", header = "midpoint.h";
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = 2, spring_limit = 0;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{6, Dash::solid, 11, 0.7};

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::midpoint(x, v, t, h, acceleration);
  }
};

/// integrate::heun.
struct Heun : Orders<2> {
  static constexpr std::string_view name = "Heun", function = "heun", header = "heun.h";
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = 2, spring_limit = 0;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{6, Dash::dashed, 10, 0.8};

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::heun(x, v, t, h, acceleration);
  }
};

/// integrate::rk4.
struct Rk4 : Orders<4> {
  static constexpr std::string_view name = "RK4", function = "rk4", header = "rk4.h";
  static constexpr long evaluations = 4;
  static constexpr double drag_limit = 2.785293563405282, spring_limit = 2.8284271247461903;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{4, Dash::solid, 13, 0.75};

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::rk4(x, v, t, h, acceleration);
  }
};

/// integrate::dopri5 with equal steps: keeps the acceleration.
struct Dopri5 : Orders<5>, KeepsAcceleration {
  static constexpr std::string_view name = "Dormand-Prince", function = "dopri5",
                                    header = "dopri5.h";
  static constexpr long evaluations = 6;
  static constexpr double drag_limit = 3.306567, spring_limit = 0.997189;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{4, Dash::dashed, 12, 0.8};

  /// One step.
  template <class Memory, class Real, class Scene>
  static void step(Memory& memory, Real t, Real h, const Scene& scene) {
    integrate::dopri5(memory[0], memory[1], memory[2], t, h, scene);
  }
};

/// integrate::predicted_euler with a given number of corrections.
template <int Corrections>
struct Corrected {
  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::predicted_euler(x, v, t, h, acceleration, Corrections);
  }
};

/// integrate::predicted_euler with one correction.
struct PredictedEuler : Orders<1>, Corrected<1> {
  static constexpr std::string_view name = "predicted Euler", function = "predicted_euler",
                                    header = "predicted_euler.h";
  static constexpr long evaluations = 2;
  static constexpr double drag_limit = 1, spring_limit = 1;
  static constexpr int free_fall_after_ten_steps = 55;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{5, Dash::dotted, 3, 0.8};
};

inline constexpr Midpoint midpoint;  ///< instance for generic code
inline constexpr Heun heun;          ///< instance for generic code
inline constexpr Rk4 rk4;            ///< instance for generic code
inline constexpr Dopri5 dopri5;      ///< instance for generic code

/// To hand on.
template <int Corrections = 1>
inline constexpr Corrected<Corrections> predicted_euler;

}  // namespace measure

namespace list {

/// Slopes, and weighted sums of them.
using RungeKuttaKin = std::tuple<measure::Midpoint, measure::Heun, measure::Rk4, measure::Dopri5,
                                 measure::PredictedEuler>;

}  // namespace list
