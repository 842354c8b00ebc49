// SPDX-License-Identifier: MIT-0
/// @file
/// Somebody who jumps: chapter 1 builds it, and the level keeps it.
#pragma once
#include "../play.h"
#include "integrate/euler.h"

namespace play {

// [jumper]
/// Starts from the ground at five metres a second, and ends on it.
struct Jumper {
  Vec x, v{0, 5};

  static Vec gravity(Vec, Vec, double) { return {0, -9.81}; }

  void step(double h) {
    if (x.y >= 0) integrate::euler(x, v, 0.0, h, gravity);
  }
};
// [jumper]

}  // namespace play
