// SPDX-License-Identifier: MIT-0
// Chapter 6: two moons around one planet, and two lines swapped.
// [moons]
#include "../play/moon.h"
#include "integrate/euler.h"
#include "integrate/symplectic_euler.h"

int main() {
  play::Moon moon{.at = {-8, 0}}, swapped{.at = {8, 0}};
  play::Film film({-16, -10}, {16, 8}, 3);
  const double h = 1.0 / 60;
  for (int n = 0; n <= 30 * 60; ++n) {
    if (n % 3 == 0) {
      film.picture(3 * h);
      moon.draw(film, "Euler");
      swapped.draw(film, "symplectic Euler");
      film.label(moon.at + play::Vec{0, -9}, "Euler");
      film.label(swapped.at + play::Vec{0, -9}, "symplectic Euler");
    }
    if (n % 600 == 0) {
      std::cout << n * h << " s: Euler's moon is " << length(moon.x - moon.at)
                << " m out, the other " << length(swapped.x - swapped.at) << " m\n";
    }
    integrate::euler(moon.x, moon.v, n * h, h, moon);
    integrate::symplectic_euler(swapped.x, swapped.v, n * h, h, swapped);
  }
  return film.write("play.html");
}
// [moons]
