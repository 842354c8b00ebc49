// SPDX-License-Identifier: MIT-0
/// @file
/// A rope with a weight, for the level.
#pragma once
#include "../play.h"
#include "shelf/link.h"

namespace play {

// [rope]
/// Twenty links of ten centimetres that hang from a nail, and half a kilogram at the end.
struct Rope {
  static constexpr int count = 21;
  Vec at, x[count], before[count];
  double tension[count - 1] = {}, w[count];

  /// Begins level, to the right of the nail.
  explicit Rope(Vec nail) : at(nail) {
    for (int i = 0; i < count; ++i) {
      x[i] = before[i] = at + Vec{0.1 * i, 0};
      w[i] = i == 0 ? 0 : i == count - 1 ? 1 / 0.5 : 1 / 0.01;
    }
  }

  void step(double h) {
    const shelf::Rope<double> links{.length = 0.1};
    const auto free = [](Vec place) { return place; };
    shelf::rope_step(x, before, tension, w, count, links, Vec{0, -9.81}, h, length, free);
  }

  void draw(Film& film, const char* method = "Störmer–Verlet") const {
    for (int i = 2; i < count; i += 2) film.line(x[i - 2], x[i], method);
    film.circle(x[count - 1], 0.3, method);
  }
};
// [rope]

}  // namespace play
