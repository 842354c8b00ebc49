// SPDX-License-Identifier: MIT-0
/// @file
/// Frames that do not keep time, made up but always the same.
#pragma once
#include <cstdint>

namespace frames {

/// A game that means to draw sixty frames a second: most are up to a quarter shorter or longer than
/// they should be, and one in sixteen is a hitch of 50 to 100 ms.
struct Uneven {
  std::uint32_t seed = 1;  ///< another seed, other frames

  /// Length of the next frame [s].
  constexpr double next() {
    const double size = 0.75 + 0.5 * random();
    return random() < 1.0 / 16 ? 0.050 + 0.050 * random() : size / 60;
  }

  /// The next number between 0 and 1.
  /// @see Press et al., Numerical Recipes (1992), section 7.1, "quick and dirty generators"
  constexpr double random() {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) / 16777216.0;
  }
};

}  // namespace frames
