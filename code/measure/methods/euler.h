// SPDX-License-Identifier: MIT-0
/// @file
/// The methods of one evaluation, as objects that can be handed to run() and to the other
/// measurements.
#pragma once
#include <string_view>
#include <tuple>

#include "integrate/constant_acceleration.h"
#include "integrate/euler.h"
#include "integrate/symplectic_euler.h"
#include "measure/methods/traits.h"

namespace measure {

/// integrate::euler.
struct Euler : Orders<1> {
  static constexpr std::string_view name = "Euler", function = "euler", header = "euler.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 0;
  static constexpr int free_fall_after_ten_steps = 45;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{1, Dash::solid, 7, 0.6};

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::euler(x, v, t, h, acceleration);
  }
};

/// integrate::constant_acceleration.
struct ConstantAcceleration : Orders<1> {
  static constexpr std::string_view name = "constant acceleration",
                                    function = "constant_acceleration",
                                    header = "constant_acceleration.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 0;
  static constexpr int free_fall_after_ten_steps = 50;
  static constexpr bool symplectic = false, reversible = false, conserves_angular_momentum = false;
  static constexpr bool allows_negative_step = true, contender = false;
  static constexpr FigureStyle style{1, Dash::dashed, 5, 0.55};

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::constant_acceleration(x, v, t, h, acceleration);
  }
};

/// integrate::symplectic_euler.
struct SymplecticEuler : Orders<1> {
  static constexpr std::string_view name = "symplectic Euler", function = "symplectic_euler",
                                    header = "symplectic_euler.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 55;
  static constexpr bool symplectic = true, reversible = false, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = true;
  static constexpr FigureStyle style{2, Dash::solid, 5, 0.55};

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::symplectic_euler(x, v, t, h, acceleration);
  }
};

/// integrate::symplectic_euler_position_first.
struct SymplecticEulerPositionFirst : Orders<1> {
  static constexpr std::string_view name = "symplectic Euler, position first",
                                    function = "symplectic_euler_position_first",
                                    header = "symplectic_euler.h";
  static constexpr long evaluations = 1;
  static constexpr double drag_limit = 2, spring_limit = 2;
  static constexpr int free_fall_after_ten_steps = 45;
  static constexpr bool symplectic = true, reversible = false, conserves_angular_momentum = true;
  static constexpr bool allows_negative_step = true, contender = false;

  /// One step.
  constexpr void operator()(auto& x, auto& v, auto t, auto h, auto&& acceleration) const {
    integrate::symplectic_euler_position_first(x, v, t, h, acceleration);
  }
};

inline constexpr Euler euler;                                 ///< instance for generic code
inline constexpr ConstantAcceleration constant_acceleration;  ///< instance for generic code
inline constexpr SymplecticEuler symplectic_euler;            ///< instance for generic code
inline constexpr SymplecticEulerPositionFirst
    symplectic_euler_position_first;  ///< instance for generic code

}  // namespace measure

namespace list {

/// Euler’s method and its kin.
using EulerFamily = std::tuple<measure::Euler, measure::ConstantAcceleration,
                               measure::SymplecticEuler, measure::SymplecticEulerPositionFirst>;

}  // namespace list
