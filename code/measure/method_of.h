// SPDX-License-Identifier: MIT-0
/// @file
/// Makes a Method of a step.
#pragma once
#include <array>
#include <tuple>
#include <type_traits>

#include "measure/method.h"
#include "measure/run.h"

namespace measure {

/// True of a step that moves one kind of vector.
template <class Step, class Vec>
concept Moves =
    requires(Vec& x, const Force<Vec>& force) { Step()(x, x, 0.0, 0.0, force); } ||
    requires(const scenes::State<Vec>& s, const Force<Vec>& force) { Step().start(s, 0.0, force); };

/// Returns the functions of a step for one kind of vector; nulls if it doesn't move them.
/// @tparam Step  of an object without members: a lambda without captures, or one with a memory
template <class Step, class Vec>
constexpr Stepper<Vec> stepper_of() {
  using Memory = typename Stepper<Vec>::Memory;
  if constexpr (Moves<Step, Vec>) {
    return {[](const scenes::State<Vec>& s, double h, const Force<Vec>& force) {
              const auto memory = measure::start(Step(), s, h, force);
              return Memory(memory.begin(), memory.end());
            },
            [](Memory& memory, double t, double h, const Force<Vec>& force) {
              measure::advance(Step(), memory, t, h, force);
            },
            [](const Memory& memory, double t, double h, const Force<Vec>& force) {
              return measure::to_state(Step(), memory, t, h, force);
            }};
  } else {
    return {};
  }
}

/// A step behind one type.
/// @param name  as in the book
/// @param function  in integrate, if it is there
/// @param header  that has it
template <class Step>
constexpr Method method_of(const Step&, std::string_view name = "", std::string_view function = "",
                           std::string_view header = "") {
  static_assert(std::is_empty_v<Step>,
                "a Method is made of a lambda without captures, or of an object without members");
  return {name,
          function,
          header,
          stepper_of<Step, double>(),
          stepper_of<Step, Eigen::Vector2d>(),
          stepper_of<Step, Eigen::VectorXd>()};
}

/// A method of the book behind one type.
template <class Listed>
constexpr Method method_of() {
  return method_of(Listed(), Listed::name, Listed::function, Listed::header);
}

/// All methods of a list behind one type.
template <class... Methods>
constexpr std::array<Method, sizeof...(Methods)> methods_of(std::tuple<Methods...>) {
  return {method_of<Methods>()...};
}

}  // namespace measure
