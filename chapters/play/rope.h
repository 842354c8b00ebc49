// SPDX-License-Identifier: MIT-0
/// @file
/// A rope with a weight: chapter 5 builds it, and the level keeps it.
#pragma once
#include "../play.h"
#include "shelf/link.h"

namespace play {

// [rope]
/// Twenty links of ten centimetres between points of ten grams, and a weight at the lower end.
struct Rope {
  Vec at, peg;  // what it hangs from, and what it may lie on
  double radius = 0.12;
  Vec x[21], before[21];
  double tension[20] = {}, w[21];  // w is 1/m, and 0 for what is held

  Rope(Vec hook, Vec along, Vec round) : at(hook), peg(round) {
    for (int i = 0; i <= 20; ++i) x[i] = before[i] = at + (0.1 * i) * along, w[i] = 1 / 0.01;
    w[0] = 0, w[20] = 1 / 0.1;
  }
  Vec outside(Vec place) const {
    const Vec away = place - peg;
    const double distance = length(away);
    return distance < radius ? peg + (radius / distance) * away : place;
  }
  void step(double h) {
    shelf::rope_step(x, before, tension, w, 21, shelf::Rope<double>{0.1}, Vec{0, -9.81}, h, length,
                     [this](Vec place) { return outside(place); });
  }
  void draw(Film& film) const {
    film.circle(peg, radius, "scenery");
    for (int i = 2; i <= 20; i += 2) film.line(x[i - 2], x[i], "Störmer–Verlet");
    film.circle(x[20], 0.08, "Störmer–Verlet");
  }
};
// [rope]

}  // namespace play
