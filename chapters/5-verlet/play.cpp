// SPDX-License-Identifier: MIT-0
// Chapter 5: a rope with a weight, a peg that it lies on, and a hand.
// [rope]
#include "../play/rope.h"
using play::Vec;

int main() {
  play::Rope rope({11, 9}, {1, 0}, {11.6, 8.6});
  const int substeps = 8;
  double longest = 0;
  play::Film film({9, 6.7}, {13.4, 9.5});
  // [rope]

  // [hand]
  for (int frame = 0; frame < 420; ++frame) {
    const bool held = frame >= 150 && frame < 240;
    rope.w[20] = held ? 0 : 1 / 0.1;
    for (int n = 0; n < substeps; ++n) {
      if (held) rope.x[20] = rope.x[20] + 0.01 * (Vec{10.8, 8.4} - rope.x[20]);
      rope.step(1 / 60.0 / substeps);
    }
    // [hand]

    // [draw]
    double length = 0;
    for (int i = 1; i <= 20; ++i) length += play::length(rope.x[i] - rope.x[i - 1]);
    longest = length > longest ? length : longest;
    if (frame % 60 == 59)
      std::cout << "After " << (frame + 1) / 60 << " s it is " << length << " m long, at most "
                << longest << " m so far.\n";
    if (frame % 2 != 0) continue;
    film.picture(1 / 30.0);
    rope.draw(film);
    film.label({9.2, 9.2}, held ? "held by the weight" : "hanging free");
  }
  return film.write("play.html");
}
// [draw]
