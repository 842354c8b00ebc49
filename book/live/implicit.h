// SPDX-License-Identifier: MIT-0
/// @file
/// The implicit methods as objects that can be handed on, for a page, which has no exceptions.
#pragma once
#include <limits>

#include "integrate/backward_euler.h"
#include "integrate/trapezoid.h"
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

}  // namespace live
