// SPDX-License-Identifier: MIT-0
// Chapter 3: RK4 written out, and the same with one wrong index.
// [slip]
#include "../play/drone.h"
using play::Drone;
using play::Vec;

struct Slope {
  Vec x, v;
};

void step(Drone& drone, double h, bool slip) {
  const auto look = [&](double share, Slope along) -> Slope {
    const Vec x = drone.x + share * h * along.x, v = drone.v + share * h * along.v;
    return {v, Drone::pull(x, v, 0)};
  };
  const Slope first = look(0, {}), second = look(0.5, first), third = look(0.5, second),
              fourth = look(1, slip ? second : third);
  drone.x = drone.x + (h / 6) * (first.x + 2 * second.x + 2 * third.x + fourth.x);
  drone.v = drone.v + (h / 6) * (first.v + 2 * second.v + 2 * third.v + fourth.v);
}
// [slip]

// [turn]
int main() {
  play::Film film({-13, -16}, {37, 13}, 6);
  for (int rate : {1, 2, 4}) {  // steps a second
    Drone right{.at = {0, 0}, .method = "RK4"}, wrong{.at = {24, 0}, .method = "scenery"};
    play::Hand hand;
    for (int n = 1; n <= 24 * rate; ++n) {
      step(right, 1.0 / rate, false);
      step(wrong, 1.0 / rate, true);
      hand.turn(60 / rate);
      if (rate != 1) continue;
      film.picture(1);
      film.label({0, -14.5}, "RK4");
      film.label({24, -14.5}, "one wrong index");
      for (const Drone& drone : {right, wrong}) {
        film.circle(drone.at + 10 * hand.tip, 0.5, "true");
        drone.draw(film);
      }
    }
    std::cout << rate << " a second: RK4 " << length(right.x - 10 * hand.tip) << " m off, the slip "
              << length(wrong.x - 10 * hand.tip) << " m\n";
  }
  return film.write("play_index.html");
}
// [turn]
