// SPDX-License-Identifier: MIT-0
/// @file
/// The solver that the implicit methods ask for, made from a scene's own derivatives.
#pragma once
#include <type_traits>

#include "integrate/dense_system.h"

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

}  // namespace measure
