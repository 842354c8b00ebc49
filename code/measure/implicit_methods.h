// SPDX-License-Identifier: MIT-0
/// @file
/// The implicit methods as objects that can be handed to run() and to the other measurements.
#pragma once
#include <limits>
#include <stdexcept>

#include "integrate/backward_euler.h"
#include "integrate/trapezoid.h"
#include "measure/length.h"
#include "measure/solver_of.h"

namespace measure {

/// Says so when an implicit step did not succeed.
inline void require_solved(bool solved) {
  if (!solved) throw std::runtime_error("an implicit step could not be solved");
}

/// integrate::backward_euler on a scene with a `jacobian`, as an object that can be handed on.
inline constexpr auto backward_euler = [](auto& x, auto& v, auto t, auto h, const auto& scene) {
  require_solved(integrate::backward_euler(x, v, t, h, scene, solver_of(scene)));
};

/// integrate::backward_euler_newton on a scene with a `jacobian`; down to rounding.
inline constexpr auto backward_euler_newton = [](auto& x, auto& v, auto t, auto h,
                                                 const auto& scene) {
  const auto size = [](const auto& y) { return decltype(h)(length(y)); };
  const auto tolerance = 512 * std::numeric_limits<decltype(h)>::epsilon() * (1 + size(v));
  require_solved(
      integrate::backward_euler_newton(x, v, t, h, scene, solver_of(scene), size, tolerance) > 0);
};

/// integrate::trapezoid on a scene with a `jacobian`, as an object that can be handed on.
inline constexpr auto trapezoid = [](auto& x, auto& v, auto t, auto h, const auto& scene) {
  require_solved(integrate::trapezoid(x, v, t, h, scene, solver_of(scene)));
};

/// integrate::trapezoid_newton on a scene with a `jacobian`; down to rounding.
inline constexpr auto trapezoid_newton = [](auto& x, auto& v, auto t, auto h, const auto& scene) {
  const auto size = [](const auto& y) { return decltype(h)(length(y)); };
  const auto tolerance = 512 * std::numeric_limits<decltype(h)>::epsilon() * (1 + size(v));
  require_solved(integrate::trapezoid_newton(x, v, t, h, scene, solver_of(scene), size, tolerance) >
                 0);
};

}  // namespace measure
