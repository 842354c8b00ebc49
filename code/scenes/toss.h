// SPDX-License-Identifier: MIT-0
/// @file
/// A ball that is tossed straight up.
#pragma once
#include "scenes/linear_drag.h"

namespace scenes {

/// A ball in a vacuum, tossed straight up: x'' = -g.
struct Toss : LinearDrag<> {
  /// @param speed  at the start, upwards [m/s]
  constexpr explicit Toss(double speed) : LinearDrag<>{.c = 0, .v0 = speed} {}

  /// Energy per unit mass, which is conserved [J/kg].
  constexpr double energy(double x, double v) const { return v * v / 2 + g * x; }
};

}  // namespace scenes
