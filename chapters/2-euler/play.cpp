// SPDX-License-Identifier: MIT-0
// Chapter 2: a drone on a leash, stepped by Euler's method.
// [main]
#include "../play/drone.h"
using play::Drone;
using play::Vec;

int main() {
  const double h = 1 / 60.0;
  Drone drone;
  play::Hand hand;
  bool outside = false;
  play::Film film({-25, -5}, {15, 27}, 8);
  for (int picture = -60; picture <= 600; ++picture) {
    film.picture(picture < 0 ? 0 : 8 / 60.0);  // no time at first: draws the circles
    film.trail(drone.at + 12 * hand.tip, "scenery");
    film.trail(drone.at + 10 * hand.tip, "true");
    film.circle(drone.at + 10 * hand.tip, 0.5, "true");
    drone.draw(film);
    hand.turn(8);
    if (picture < 0) continue;
    // [main]

    // [step]
    const double distance = play::length(drone.x);
    film.label({-24, 25}, std::to_string(distance).substr(0, 5) + " m");
    if (picture % 120 == 0) std::cout << picture / 60 << " turns: " << distance << " m\n";
    if (distance > 12 && !outside) {
      std::cout << "over the fence after " << picture / 60.0 << " turns\n";
      outside = true;
    }
    for (int frame = 0; frame < 8; ++frame) drone.step(h);  // eight to a picture
  }
  return film.write("play.html");
}
// [step]
