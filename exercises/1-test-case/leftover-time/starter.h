// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// How many steps are due in a frame.
/// @param saved  game time that the frames before left over [s]; leaves what is not yet spent
/// @param length  how long the frame took for the player [s], 0 or more
/// @param pace  seconds of the game in one of the player's: 1, less in slow motion, 0 in a pause,
///   up to 4 in fast motion
/// @param h  step size, in game time [s]
inline int steps_due(double& saved, double length, double pace, double h) {
  saved += length;
  int steps = 0;
  while (saved >= h) {
    saved -= length;
    ++steps;
  }
  return steps;
}

/// How far the picture is between the last two states: 0 at the older one, 1 at the newer.
inline double blend(double saved, double h) {
  return saved / h;
}
