// SPDX-License-Identifier: MIT-0
/// @file
/// A drone on a leash: chapter 2 builds it, and the level keeps it.
#pragma once
#include <cmath>
#include <numbers>
#include <string>

#include "../play.h"
#include "integrate/euler.h"

namespace play {

// [drone]
/// Circles its tower on an elastic leash, ten metres out, once in eight seconds.
struct Drone {
  Vec at{-5, 11};                                            // where the tower stands
  static constexpr double omega = 2 * std::numbers::pi / 8;  // once in eight seconds
  Vec x{10, 0}, v{0, 10 * omega};                            // of the drone, from the tower
  std::string method = "Euler";

  /// The leash pulls inwards, by omega squared for every metre of its length.
  static Vec pull(Vec x, Vec, double) { return -omega * omega * x; }

  void step(double h) { integrate::euler(x, v, 0.0, h, pull); }

  void draw(Film& film) const {
    film.circle(at, 0.3, "scenery");
    film.line(at, at + x, "scenery");
    film.trail(at + x, method);
    film.circle(at + x, 0.5, method);
  }
};
// [drone]

// [hand]
/// Points from the tower to where the drone should be.
struct Hand {
  Vec tip{1, 0};

  void turn(int frames) {
    const double cosine = std::cos(Drone::omega / 60), sine = std::sin(Drone::omega / 60);
    for (int n = 0; n < frames; ++n)
      tip = {cosine * tip.x - sine * tip.y, sine * tip.x + cosine * tip.y};
  }
};
// [hand]

}  // namespace play
