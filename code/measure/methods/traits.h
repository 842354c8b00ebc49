// SPDX-License-Identifier: MIT-0
/// @file
/// What every method says of itself, and is held to by the tests.
//
// Of a method for any acceleration, besides its orders:
//
//   evaluations  of the acceleration in a step; `as_needed` if it iterates
//   drag_limit   below which c h has to stay on drag, so that nothing explodes
//   spring_limit below which h omega has to stay on an undamped spring; 0 is never, `always` has no
//                limit. Those of Yoshida 4 and Dormand-Prince are their own polynomials', and have
//                no closed form: the tests derive them
//   free_fall_after_ten_steps
//                how deep it falls in ten steps from rest, in g h^2: 50 is the truth
//   symplectic   whether it keeps areas in phase space
//   reversible   whether steps of -h lead back to the start, to rounding
//   conserves_angular_momentum
//                whether it does, of a planet
//   allows_negative_step
//                whether it takes negative steps at all
//   contender    whether the chapters run it against the others; not if it is a variant of one that
//                they do
//   style        how figures show it, if they do: they have to show a contender
#pragma once
#include <limits>
#include <string_view>

namespace measure {

inline constexpr double always = std::numeric_limits<double>::infinity();  ///< no limit
inline constexpr long as_needed = -1;  ///< evaluations of a method that iterates

/// The orders of a method.
/// @tparam Position  of the position, where the force does not depend on the velocity
/// @tparam Velocity  of the velocity, there
/// @tparam Drag  of both, where the force depends on the velocity
template <int Position, int Velocity = Position, int Drag = Velocity>
struct Orders {
  static constexpr int order = Position;            ///< of the position
  static constexpr int velocity_order = Velocity;   ///< of the velocity
  static constexpr int drag_order = Drag;           ///< of the position under drag
  static constexpr int drag_velocity_order = Drag;  ///< of the velocity under drag
};

/// The lines of the book's figures.
enum class Dash { solid, dashed, dotted };

/// How the book shows a method, in all figures alike. Its kin have the family's colour, another
/// dash and another symbol.
struct FigureStyle {
  int colour;          ///< of the style sheet's, `--plot-1` and so on
  Dash dash;           ///< of the line
  int symbol;          ///< gnuplot's `pointtype`
  double size;         ///< of the symbol, gnuplot's `pointsize`
  double width = 2.2;  ///< of the line, gnuplot's `linewidth`
};

/// What figures show; not all methods are.
template <class Method>
concept IsDrawn = requires { Method::style; };

/// What says all that is asked of a method.
template <class Method>
concept IsNamed = requires { Method::name, Method::function, Method::header; };

/// What says all that is asked of a method for any acceleration.
template <class Method>
concept HasAllTraits = IsNamed<Method> && requires {
  Method::order, Method::drag_order, Method::evaluations, Method::drag_limit, Method::spring_limit;
  Method::free_fall_after_ten_steps, Method::symplectic, Method::reversible,
      Method::conserves_angular_momentum;
  Method::allows_negative_step, Method::contender;
};

/// Stops the compiler with a sentence where a method doesn't say what it is called.
template <class Method>
constexpr bool require_names() {
  static_assert(IsNamed<Method>,
                "a method in code/measure/methods has no `name`, `function` or `header`");
  return true;
}

/// Stops the compiler with a sentence where a method for any acceleration doesn't say all that is
/// asked of it.
template <class Method>
constexpr bool require_all_traits() {
  static_assert(
      requires { Method::order, Method::drag_order; },
      "a method in code/measure/methods doesn't derive from Orders<...>");
  static_assert(
      requires { Method::evaluations; }, "a method in code/measure/methods has no `evaluations`");
  static_assert(
      requires { Method::drag_limit, Method::spring_limit; },
      "a method in code/measure/methods has no `drag_limit` or `spring_limit`");
  static_assert(
      requires { Method::free_fall_after_ten_steps; },
      "a method in code/measure/methods has no `free_fall_after_ten_steps`");
  static_assert(
      requires { Method::symplectic; },
      "a method in code/measure/methods doesn't say whether it is `symplectic`");
  static_assert(
      requires { Method::reversible, Method::allows_negative_step; },
      "a method in code/measure/methods doesn't say whether it is `reversible` or "
      "`allows_negative_step`");
  static_assert(
      requires { Method::conserves_angular_momentum; },
      "a method in code/measure/methods doesn't say whether it is `conserves_angular_momentum`");
  static_assert(
      requires { Method::contender; },
      "a method in code/measure/methods doesn't say whether it is a `contender`");
  static_assert(!Method::contender || IsDrawn<Method>,
                "a method in code/measure/methods is a `contender`, which figures show, and has no "
                "`style`");
  return require_names<Method>();
}

}  // namespace measure
