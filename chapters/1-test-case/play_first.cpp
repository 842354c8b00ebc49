// SPDX-License-Identifier: MIT-0
// Chapter 1: the first program. One jump on four machines.
// [first]
#include "../play.h"
using play::Vec;

struct Jumper {
  int rate;  // frames a second
  Vec x, v{0, 5};
  double highest = 0;

  void frame() {
    const Vec gravity{0, -9.81};
    // [step]
    const double h = 1.0 / rate;
    x = x + h * v;
    v = v + h * gravity;
    // [step]
    highest = x.y > highest ? x.y : highest;
  }

  void draw(play::Film& film) const {
    film.circle(x, 0.12, "Euler");
    film.line({x.x - 0.2, highest}, {x.x + 0.2, highest}, "Euler");
    film.label({x.x, -0.45}, std::to_string(rate) + " Hz");
  }
};

int main() {
  Jumper jumpers[] = {{20, {0, 0}}, {30, {1, 0}}, {60, {2, 0}}, {144, {3, 0}}};
  play::Film film({-0.6, -0.6}, {3.8, 1.7}, 0.25);  // at a quarter of the speed
  for (int tick = 0; tick < 792; ++tick) {          // 720 of them make a second
    for (Jumper& jumper : jumpers)
      if (tick % (720 / jumper.rate) == 0 && jumper.x.y >= 0) jumper.frame();
    if (tick % 3 != 0) continue;
    film.picture(3 / 720.0);
    film.line({-0.6, 1.33}, {3.8, 1.33}, "scenery");
    for (const Jumper& jumper : jumpers) jumper.draw(film);
  }
  for (const Jumper& jumper : jumpers)
    std::cout << jumper.rate << " Hz: " << jumper.highest << " m\n";
  return film.write("play_first.html");
}
// [first]
