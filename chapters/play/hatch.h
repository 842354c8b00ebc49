// SPDX-License-Identifier: MIT-0
/// @file
/// A lid on a hard spring: chapter 4 builds it, and the level keeps it.
#pragma once
#include <string>

#include "../play.h"
#include "integrate/backward_euler_spring.h"

namespace play {

// [hatch]
/// A lid over a shaft. A hard spring and a damper pull it down to where it shuts.
struct Hatch {
  static constexpr double omega = 60, zeta = 2;
  Vec at;            // where it shuts
  Vec x{0, 1}, v{};  // from there: open by a metre, and at rest

  static Vec pull(Vec x, Vec v, double) { return (-omega * omega) * x + (-2 * zeta * omega) * v; }
  void step(double h) { integrate::backward_euler_spring(x, v, h, omega, zeta); }

  void draw(Film& film, const std::string& colour = "backward Euler") const {
    film.line(at + Vec{-0.6, -0.4}, at + Vec{-0.6, 0}, "scenery");
    film.line(at + Vec{0.6, -0.4}, at + Vec{0.6, 0}, "scenery");
    for (const double up : {0.0, 0.03, 0.06})
      film.line(at + x + Vec{-0.5, up}, at + x + Vec{0.5, up}, colour);
  }
};
// [hatch]

}  // namespace play
