// SPDX-License-Identifier: MIT-0
// Chapter 4: one hatch, moved by four methods, and the truth beside them.
// [hatches]
#include "../play/hatch.h"
#include "integrate/euler.h"
#include "integrate/rk4.h"
#include "integrate/symplectic_euler.h"
using play::Hatch;

int main() {
  const char* names[] = {"Euler", "symplectic Euler", "RK4", "backward Euler", "true"};
  Hatch hatches[5];
  for (int i = 0; i < 5; ++i) hatches[i].at = {7 + 1.7 * i, 0};
  const double h = 1 / 60.0;
  play::Film film({6.1, -1.4}, {14.7, 3.1}, 1 / 7.0);
  // [hatches]

  // [frames]
  for (int frame = 0; frame <= 30; ++frame) {
    film.picture(h);
    for (int i = 0; i < 5; ++i) {
      hatches[i].draw(film, names[i]);
      film.label(hatches[i].at + play::Vec{0, -0.7}, names[i]);
      if (length(hatches[i].x) > 3) film.label(hatches[i].at + play::Vec{0, 0.5}, "gone");
    }
    if (frame % 10 == 0) {
      std::cout << "After " << frame << " frames:";
      for (const Hatch& hatch : hatches) std::cout << ' ' << hatch.x.y;
      std::cout << '\n';
    }
    integrate::euler(hatches[0].x, hatches[0].v, 0.0, h, Hatch::pull);
    integrate::symplectic_euler(hatches[1].x, hatches[1].v, 0.0, h, Hatch::pull);
    integrate::rk4(hatches[2].x, hatches[2].v, 0.0, h, Hatch::pull);
    hatches[3].step(h);
    for (int n = 0; n < 100; ++n)
      integrate::rk4(hatches[4].x, hatches[4].v, 0.0, h / 100, Hatch::pull);
  }
  return film.write("play.html");
}
// [frames]
