// SPDX-License-Identifier: MIT-0
/// @file
/// The ways to damp within a step of symplectic Euler, as objects that can be handed on.
#pragma once
#include <string_view>
#include <tuple>
#include <type_traits>

#include "integrate/linear_damping.h"
#include "measure/methods/traits.h"

namespace measure {

/// The acceleration of a scene but for its linear damping: what it would be at rest.
template <class Scene>
auto without_damping(const Scene& scene) {
  return [&scene](const auto& x, const auto& v, auto t) {
    return scene(x, std::decay_t<decltype(v)>(0 * v), t);
  };
}

/// integrate::linear_damping_explicit_last on a scene with `damping()`.
struct LinearDampingExplicitLast {
  static constexpr std::string_view name = "symplectic Euler, drag by its rate",
                                    function = "linear_damping_explicit_last",
                                    header = "linear_damping.h";

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_explicit_last(x, v, t, h, scene.damping(), without_damping(scene));
  }
};

/// integrate::linear_damping_explicit_first on a scene with `damping()`.
struct LinearDampingExplicitFirst {
  static constexpr std::string_view name = "symplectic Euler, drag by its rate, first",
                                    function = "linear_damping_explicit_first",
                                    header = "linear_damping.h";

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_explicit_first(x, v, t, h, scene.damping(), without_damping(scene));
  }
};

/// integrate::linear_damping_implicit_last on a scene with `damping()`.
struct LinearDampingImplicitLast {
  static constexpr std::string_view name = "symplectic Euler, drag divided",
                                    function = "linear_damping_implicit_last",
                                    header = "linear_damping.h";
  static constexpr FigureStyle style{2, Dash::dashed, 4, 0.55};

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_implicit_last(x, v, t, h, scene.damping(), without_damping(scene));
  }
};

/// integrate::linear_damping_implicit_first on a scene with `damping()`.
struct LinearDampingImplicitFirst {
  static constexpr std::string_view name = "symplectic Euler, drag divided first",
                                    function = "linear_damping_implicit_first",
                                    header = "linear_damping.h";

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_implicit_first(x, v, t, h, scene.damping(), without_damping(scene));
  }
};

/// integrate::linear_damping_exponential_last on a scene with `damping()`.
struct LinearDampingExponentialLast {
  static constexpr std::string_view name = "symplectic Euler, drag by its exponential",
                                    function = "linear_damping_exponential_last",
                                    header = "linear_damping.h";

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_exponential_last(x, v, t, h, scene.damping(), without_damping(scene));
  }
};

/// integrate::linear_damping_exponential_first on a scene with `damping()`.
struct LinearDampingExponentialFirst {
  static constexpr std::string_view name = "symplectic Euler, drag by its exponential, first",
                                    function = "linear_damping_exponential_first",
                                    header = "linear_damping.h";

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_exponential_first(x, v, t, h, scene.damping(),
                                                without_damping(scene));
  }
};

/// integrate::linear_damping_exact on a scene with `damping()`.
struct LinearDampingExact {
  static constexpr std::string_view name = "symplectic Euler, drag exact",
                                    function = "linear_damping_exact", header = "linear_damping.h";

  /// One step.
  void operator()(auto& x, auto& v, auto t, auto h, const auto& scene) const {
    integrate::linear_damping_exact(x, v, t, h, scene.damping(), without_damping(scene));
  }
};

inline constexpr LinearDampingExplicitLast
    linear_damping_explicit_last;  ///< instance for generic code
inline constexpr LinearDampingExplicitFirst
    linear_damping_explicit_first;  ///< instance for generic code
inline constexpr LinearDampingImplicitLast
    linear_damping_implicit_last;  ///< instance for generic code
inline constexpr LinearDampingImplicitFirst
    linear_damping_implicit_first;  ///< instance for generic code
inline constexpr LinearDampingExponentialLast
    linear_damping_exponential_last;  ///< instance for generic code
inline constexpr LinearDampingExponentialFirst
    linear_damping_exponential_first;                      ///< instance for generic code
inline constexpr LinearDampingExact linear_damping_exact;  ///< instance for generic code

}  // namespace measure

namespace list {

/// The methods that take linear damping apart from the other forces.
using DampingKin =
    std::tuple<measure::LinearDampingExplicitLast, measure::LinearDampingExplicitFirst,
               measure::LinearDampingImplicitLast, measure::LinearDampingImplicitFirst,
               measure::LinearDampingExponentialLast, measure::LinearDampingExponentialFirst,
               measure::LinearDampingExact>;

}  // namespace list
