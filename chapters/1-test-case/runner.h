// SPDX-License-Identifier: MIT-0
/// @file
/// The runner of chapter 1, who shows what is drawn between two steps.
#pragma once

inline constexpr double room = 3.17;  ///< from wall to wall [m]; seldom a whole number of steps

// [runner]
/// Somebody who runs to and fro between two walls.
struct Runner {
  double x = 0;  ///< [m]
  double v = 3;  ///< [m/s]

  /// A step, shorter than the room; a wall turns him round.
  /// @param h  step size [s]
  void step(double h) {
    x += h * v;
    if (x >= 0 && x <= room) return;
    x = (x < 0 ? 0 : 2 * room) - x;
    v = -v;
  }
};
// [runner]
