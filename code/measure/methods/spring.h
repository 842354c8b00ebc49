// SPDX-License-Identifier: MIT-0
/// @file
/// The methods for one damped spring alone, as objects that can be handed on.
#pragma once
#include <string_view>
#include <tuple>

#include "integrate/backward_euler_spring.h"
#include "integrate/rk4_linear.h"
#include "integrate/spring_exact.h"
#include "measure/methods/traits.h"

namespace measure {

/// integrate::backward_euler_spring on a scene with `omega` and `zeta`.
struct BackwardEulerSpring {
  static constexpr std::string_view name = "backward Euler on a spring",
                                    function = "backward_euler_spring",
                                    header = "backward_euler_spring.h";
  static constexpr FigureStyle style{5, Dash::dashed, 14, 0.6};

  /// One step.
  void operator()(auto& x, auto& v, auto, auto h, const auto& spring) const {
    integrate::backward_euler_spring(x, v, h, spring.omega, spring.zeta);
  }
};

/// integrate::rk4_linear on a scene with `omega` and `damping()`.
struct Rk4Linear {
  static constexpr std::string_view name = "RK4, folded", function = "rk4_linear",
                                    header = "rk4_linear.h";

  /// One step.
  void operator()(auto& x, auto& v, auto, auto h, const auto& spring) const {
    const auto stiffness = spring.omega * spring.omega;
    integrate::rk4_linear(x, v, integrate::rk4_linear_start(stiffness, spring.damping(), h));
  }
};

/// integrate::spring_exact on a scene with `omega` and `zeta`.
struct SpringExact {
  static constexpr std::string_view name = "exact step of a spring", function = "spring_exact",
                                    header = "spring_exact.h";
  static constexpr FigureStyle style{7, Dash::solid, 6, 0.6, 1.4};

  /// One step.
  void operator()(auto& x, auto& v, auto, auto h, const auto& spring) const {
    integrate::spring_exact(x, v, h, spring.omega, spring.zeta);
  }
};

/// integrate::spring_folded on a scene with `omega` and `zeta`.
struct SpringFolded {
  static constexpr std::string_view name = "exact step of a spring, folded",
                                    function = "spring_folded", header = "spring_exact.h";
  static constexpr FigureStyle style{7, Dash::dashed, 7, 0.6, 1.4};

  /// One step.
  void operator()(auto& x, auto& v, auto, auto h, const auto& spring) const {
    integrate::spring_folded(x, v, integrate::spring_folded_start(h, spring.omega, spring.zeta));
  }
};

inline constexpr BackwardEulerSpring backward_euler_spring;  ///< instance for generic code
inline constexpr Rk4Linear rk4_linear;                       ///< instance for generic code
inline constexpr SpringExact spring_exact;                   ///< instance for generic code
inline constexpr SpringFolded spring_folded;                 ///< instance for generic code

}  // namespace measure

namespace list {

/// The methods for one damped spring alone.
using SpringKin = std::tuple<measure::BackwardEulerSpring, measure::Rk4Linear, measure::SpringExact,
                             measure::SpringFolded>;

}  // namespace list
