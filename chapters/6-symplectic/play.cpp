// SPDX-License-Identifier: MIT-0
// Chapter 6: two moons around one planet, and two lines swapped.
// [moons]
#include "../play/moon.h"
#include "integrate/euler.h"
#include "integrate/symplectic_euler.h"

int main() {
  play::Moon moon, swapped;
  play::Film film({-16, -9}, {16, 9});
  const double h = 1.0 / 60;
  for (int n = 0; n <= 30 * 60; ++n) {
    if (n % 3 == 0) {
      film.picture(1 / 60.0);  // three times faster
      moon.draw(film, "Euler");
      swapped.draw(film, "symplectic Euler");
    }
    if (n % 600 == 0) {
      std::cout << n * h << " s: Euler's moon is " << length(moon.x) << " m out, the other "
                << length(swapped.x) << " m\n";
    }
    integrate::euler(moon.x, moon.v, n * h, h, moon);
    integrate::symplectic_euler(swapped.x, swapped.v, n * h, h, swapped);
  }
  return film.write("play.html");
}
// [moons]
