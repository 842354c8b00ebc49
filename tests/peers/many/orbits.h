// SPDX-License-Identifier: MIT-0
#pragma once
#include <array>
#include <cstddef>

#include "orbit/state.h"

namespace many {

constexpr std::size_t count = 32;

/// Planets around one sun, a structure of arrays.
struct Orbits {
  alignas(64) std::array<double, count> x, y, vx, vy;
};

inline Orbits start() {
  Orbits all{};
  const auto each = orbit::start(count);
  for (std::size_t i = 0; i < count; ++i) all.x[i] = each[i].x, all.vy[i] = each[i].vy;
  return all;
}

}  // namespace many
