// SPDX-License-Identifier: MIT-0
/// @file
/// A moon: chapter 6 builds it, and the level keeps it.
#pragma once
#include "../play.h"
#include "integrate/symplectic_euler.h"

namespace play {

// [moon]
/// Circles a planet at three and a half metres, once in about four seconds.
struct Moon {
  Vec at;  ///< the planet
  Vec x = at + Vec{3.5, 0}, v{0, 5.25};

  /// The pull, which falls with the square of the distance.
  Vec operator()(Vec place, Vec, double) const {
    const Vec way = place - at;
    const double r = length(way);
    return (-96.5 / (r * r * r)) * way;
  }

  void step(double h) { integrate::symplectic_euler(x, v, 0.0, h, *this); }

  void draw(Film& film, const char* method = "symplectic Euler") const {
    film.circle(at, 0.7, "scenery");
    film.trail(x, method);
    film.circle(x, 0.3, method);
  }
};
// [moon]

}  // namespace play
