// SPDX-License-Identifier: MIT-0
#pragma once
#include <array>
#include <cstddef>

#include "orbit/by_hand.h"
#include "orbit/state.h"

namespace many {

constexpr std::size_t count = 32;

/// Planets around one sun, a structure of arrays.
struct Orbits {
  alignas(64) std::array<double, count> x, y, vx, vy;
};

/// Each planet starts with a little less speed than the one before.
inline Orbits start() {
  Orbits all{};
  for (std::size_t i = 0; i < count; ++i) {
    all.x[i] = orbit::start.x;
    all.vy[i] = orbit::start.vy - 0.01 * double(i);
  }
  return all;
}

}  // namespace many
