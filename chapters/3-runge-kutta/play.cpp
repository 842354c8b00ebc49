// SPDX-License-Identifier: MIT-0
// Chapter 3: three drones, whose methods may ask for the acceleration equally often.
// [racer]
#include "../play/drone.h"
#include "integrate/midpoint.h"
#include "integrate/rk4.h"
using play::Drone;
using play::Vec;

struct Racer {
  Drone drone;
  int price;  // evaluations of the acceleration in a step
  int asked = 0;

  void step(double h) {
    const auto pull = [&](Vec x, Vec v, double t) {
      ++asked;
      return Drone::pull(x, v, t);
    };
    Vec &x = drone.x, &v = drone.v;
    if (drone.method == "Euler") integrate::euler(x, v, 0.0, h, pull);
    if (drone.method == "midpoint") integrate::midpoint(x, v, 0.0, h, pull);
    if (drone.method == "RK4") integrate::rk4(x, v, 0.0, h, pull);
  }
};
// [racer]

// [main]
int main() {
  Racer racers[] = {{{.at = {-30, 0}, .method = "Euler"}, 1},
                    {{.at = {0, 0}, .method = "midpoint"}, 2},
                    {{.at = {30, 0}, .method = "RK4"}, 4}};
  const int rate = 10;  // evaluations a second
  play::Hand hand;
  play::Film film({-47, -23}, {46, 17}, 2);
  for (int tick = 1; tick <= 16 * rate; ++tick) {  // sixteen seconds: two turns
    hand.turn(60 / rate);
    film.picture(1.0 / rate);
    for (Racer& racer : racers) {
      if (tick % racer.price == 0) racer.step(double(racer.price) / rate);
      film.trail(racer.drone.at + 10 * hand.tip, "true");
      film.circle(racer.drone.at + 10 * hand.tip, 0.5, "true");
      racer.drone.draw(film);
      film.label(racer.drone.at + Vec{0, -20}, racer.drone.method);
    }
  }
  for (const Racer& racer : racers)
    std::cout << racer.drone.method << ": " << racer.asked << " evaluations, "
              << play::length(racer.drone.x) << " m from the tower, "
              << play::length(racer.drone.x - 10 * hand.tip) << " m off\n";
  return film.write("play.html");
}
// [main]
