// SPDX-License-Identifier: MIT-0
/// @file
/// The implicit methods as objects that can be handed to run() and to the other measurements.
#pragma once
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "integrate/backward_euler.h"
#include "integrate/dense_system.h"
#include "integrate/trapezoid.h"
#include "measure/length.h"

namespace measure {

/// Solves the linear systems of a scene with few unknowns, from the scene's `jacobian`.
template <class Scene>
auto solver_of(const Scene& scene) {
  return [&scene](const auto& x, const auto& v, auto t, auto p, auto q, auto& change) {
    using Vec = std::decay_t<decltype(x)>;
    using Real = decltype(p);
    if constexpr (std::is_arithmetic_v<Vec>) {
      Real matrix = 1;
      scene.jacobian(x, v, t,
                     [&](int, int, Real dadx, Real dadv) { matrix += p * dadx + q * dadv; });
      change = change / matrix;
      return true;
    } else {
      const auto jacobian = [&scene](const auto& at, const auto& speed, auto now, auto&& add) {
        scene.jacobian(at, speed, now, add);
      };
      using Jacobian = std::decay_t<decltype(jacobian)>;
      integrate::DenseSystem<Jacobian, Real, Vec::RowsAtCompileTime> system(jacobian);
      return system(x, v, t, p, q, change);
    }
  };
}

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
