// SPDX-License-Identifier: MIT-0
// A toy car that bounces on its suspension, and what a pen writes of it.
#include "home/scene.h"

namespace {

constexpr double h = 0.1, omega = 7.5, reach = 0.8;  // [s], [rad/s], [m]
constexpr int steps = 80, pictures_a_step = 3;

judge::Path bounced(judge::Student& who, double told) {
  const std::vector<double> states =
      who.call(0, {reach, 0, h, told, 0, static_cast<double>(steps)}, 2 * steps);
  judge::Path path{.h = h, .states = {{{0, reach, 0}, {}}}, .evaluations = {}};
  for (std::size_t n = 0; n < states.size(); n += 2)
    path.states.push_back({{0, states[n], 0}, {0, states[n + 1], 0}});
  return path;
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  struct Car {
    const char* name;
    double at;
    judge::Path yours, right;
  };
  const auto told = [](judge::Student& who) { return who.call(1, {omega, h}, 1)[0]; };
  const Car cars[] = {
      {"by your step", 3, bounced(yours, omega), bounced(right, omega)},
      {"by the rule, told your ω", 0, bounced(right, told(yours)), bounced(right, told(right))}};
  for (int picture = 0; picture <= steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step), t = now * h;
    stage.picture(h / pictures_a_step);
    for (const Car& car : cars) {
      const Vec road{0, car.at, 0}, mine = road + grade::place(car.yours, now),
                                    best = road + grade::place(car.right, now);
      const Vec pen{1.4 + t, 0, 0};
      stage.trail(std::string(car.name) + " wanted",
                  road + pen + Vec{0, reach * std::cos(omega * t), 0}, "scenery");
      stage.trails(car.name, mine + pen, best + pen);
      for (const double wheel : {-0.5, 0.5})
        stage.ball("wheel", road + Vec{wheel, -1.2, 0}, 0.15, "scenery");
      stage.boxes(car.name, mine, best, {1.6, 0.5, 0});
      stage.balls(car.name + std::string(" pen"), mine + pen, best + pen, 0.07);
      stage.label(road + Vec{5, 1.25, 0}, car.name);
    }
  }
}

const grade::Staged staged({
    .exercise = "4-implicit/slow-suspension",
    .caption =
        "An undamped car bounces for eight seconds, at ten steps a second, and a pen writes it "
        "down; the grey line swings at the rate that the designer wants. Above, your step beside "
        "the trapezoid rule, which is a little slow. Below, the trapezoid rule is told the ω "
        "that your function answers: with the right one it keeps to the grey line.",
    .view = {{-1.2, -1.6}, {9.8, 4.6}},
    .film = film,
});

}  // namespace
