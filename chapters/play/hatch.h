// SPDX-License-Identifier: MIT-0
/// @file
/// A hatch with a hard spring, for the level.
#pragma once
#include "../play.h"
#include "integrate/backward_euler_spring.h"

namespace play {

// [hatch]
/// A stiff spring shuts it from a metre, and a damper twice too strong slows it.
struct Hatch {
  Vec at{7, 0};
  double open = 1, speed = 0;
  static constexpr double omega = 60, zeta = 2;

  void step(double h) { integrate::backward_euler_spring(open, speed, h, omega, zeta); }

  void draw(Film& film, const char* method = "backward Euler") const {
    film.line(at + Vec{-1, 0}, at + Vec{-1, 1}, "scenery");
    film.line(at + Vec{1, 0}, at + Vec{1, 1}, "scenery");
    film.line(at + Vec{-1, open}, at + Vec{1, open}, method);
  }
};
// [hatch]

}  // namespace play
