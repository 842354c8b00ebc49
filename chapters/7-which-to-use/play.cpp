// SPDX-License-Identifier: MIT-0
// Chapter 7: the whole level, and for each thing the method that it needs.
// [things]
#include "../play/crate.h"
#include "../play/drone.h"
#include "../play/hatch.h"
#include "../play/jumper.h"
#include "../play/moon.h"
#include "../play/rope.h"
#include "integrate/constant_acceleration.h"
#include "integrate/rk4.h"
#include "integrate/spring_exact.h"
#include "integrate/velocity_verlet.h"
using play::Vec;

struct Level {
  play::Jumper jumper{.x = {-13, 0}};
  play::Drone drone{.method = "RK4"};
  play::Hatch hatch{.at = {6.5, 0.4}};
  play::Rope rope{{11, 6}, {1, 0}, {8, 6}};
  play::Moon moon{.at = {10.4, 16.5}};
  play::Crate crate{.at = {12.5, 1.25}};
  Vec pull = moon(moon.x, moon.v, 0);
  // [things]

  // [step]
  void step(double h) {
    integrate::constant_acceleration(jumper.x, jumper.v, 0.0, h, jumper.gravity);
    if (jumper.x.y < 0) jumper.x.y = 0, jumper.v = {0, 5};
    integrate::rk4(drone.x, drone.v, 0.0, h, play::Drone::pull);
    integrate::spring_exact(hatch.x, hatch.v, h, hatch.omega, hatch.zeta);
    for (int substep = 0; substep < 8; ++substep) rope.step(h / 8);
    integrate::velocity_verlet(moon.x, moon.v, pull, 0.0, h, moon);
    crate.step(h);
  }
  // [step]

  // [draw]
  void draw(play::Film& film) const {
    film.picture(1 / 30.0);
    film.line({-16, 0}, {15, 0}, "scenery");
    film.line({-12, 1.33}, {-10, 1.33}, "scenery");
    film.circle(jumper.x + Vec{0, 0.4}, 0.4, "true");
    drone.draw(film);
    hatch.draw(film, "true");
    rope.draw(film);
    film.circle(rope.x[20], 0.3, "Störmer–Verlet");
    moon.draw(film, "velocity Verlet");
    crate.draw(film);
    for (const double x : {jumper.x.x, hatch.at.x}) film.label({x, -0.75}, "exact");
    film.label({drone.at.x, -0.75}, drone.method);
    film.label({11, 7.3}, "Störmer–Verlet");
    film.label({10.4, 11.8}, "velocity Verlet");
  }
};
// [draw]

// [main]
int main() {
  Level level;
  const double thrown = level.crate.energy();
  play::Film film({-16, -1.8}, {15, 21.8});
  for (int n = 0; n < 8 * 60; ++n) {
    if (n % 2 == 0) level.draw(film);
    level.step(1 / 60.0);
  }
  const Vec weight = level.rope.x[20] - level.rope.at;
  std::cout << "drone " << length(level.drone.x) << " m out, moon "
            << length(level.moon.x - level.moon.at) << " m\nweight " << length(weight)
            << " m from its nail, crate at " << 100 * level.crate.energy() / thrown
            << " % of its energy\n";
  return film.write("play.html");
}
// [main]
