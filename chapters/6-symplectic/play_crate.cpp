// SPDX-License-Identifier: MIT-0
// Chapter 6: one crate, thrown three times, and turned in three ways.
// [crates]
#include "../play/crate.h"

int main() {
  play::Crate naive{.at = {-3, 0}}, bullet, split{.at = {3, 0}};
  play::Film film({-4.5, -2.3}, {4.5, 1.5});
  const double h = 1.0 / 60, thrown = split.energy();
  for (int n = 0; n < 300; ++n) {
    if (n % 2 == 0) {
      film.picture(1 / 30.0);
      naive.draw(film, "Euler", "naive");
      bullet.draw(film, "backward Euler", "Bullet");
      split.draw(film, "velocity Verlet", "rotations");
    }
    const auto w = angular_velocity(naive.q, naive.L, naive.inertia);
    shelf::turn_exact(naive.q, w, h);
    shelf::spin_by_bullet(bullet.q, bullet.L, bullet.inertia, h);
    split.step(h);
  }
  for (const auto* crate : {&naive, &bullet, &split})
    std::cout << 100 * crate->energy() / thrown << " % of the energy\n";
  return film.write("play_crate.html");
}
// [crates]
