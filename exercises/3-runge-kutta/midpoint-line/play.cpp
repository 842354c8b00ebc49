// SPDX-License-Identifier: MIT-0
// A drone that follows a road through gusts, and looks ahead by three shares of a step.
#include "home/scene.h"

namespace {

constexpr double h = 0.5;  // [s]
constexpr int steps = 28, pictures_a_step = 6;

struct Machine {
  const char* name;
  double share, lane;

  judge::Path flown(judge::Student& who) const {
    constexpr double along = 3;  // how fast the place that it follows moves on [m/s]
    const Acceleration gusts = [](const Vec& x, const Vec& v, double t) {
      const Vec place{along * t, 0, 0}, moves{along, 0, 0};
      return 1.5 * (place - x) + 0.5 * (moves - v) +
             Vec{3 * std::sin(1.7 * t), 4 * std::cos(2.1 * t + 0.3 * x.x), 0};
    };
    who.call(0, {share}, 0);
    return who.watch({{0, 0, 0}, {along, 0, 0}}, h, steps, gusts, 1);
  }
};

constexpr Machine machines[] = {{"console: half a step", 0.5, 18},
                                {"phone: two thirds", 2.0 / 3, 9},
                                {"replay: a whole step", 1, 0}};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  std::vector<judge::Path> mine, best;
  for (const Machine& machine : machines) {
    mine.push_back(machine.flown(yours));
    best.push_back(machine.flown(right));
  }
  for (int picture = 0; picture <= steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step);
    stage.picture(h / pictures_a_step);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Machine& machine = machines[n];
      const Vec lane{0, machine.lane, 0};
      const Vec drone = lane + grade::place(mine[n], now), ring = lane + grade::place(best[n], now);
      stage.line(lane, lane + Vec{42, 0, 0}, "scenery");
      stage.trails(machine.name, drone, ring);
      stage.balls(machine.name, drone, ring, 0.5);
      stage.label(lane + Vec{21, -4, 0}, machine.name);
    }
  }
}

const grade::Staged staged({
    .exercise = "3-runge-kutta/midpoint-line",
    .caption =
        "A drone follows a road through gusts, at two steps a second, twice as fast as in the "
        "game. Each of the three machines looks ahead by another share of the step, so that "
        "their paths differ a little. Yours should lie on the right one beneath it: with weights "
        "that do not fit the share it strays.",
    .view = {{-2, -5}, {47, 23}, 2},
    .film = film,
});

}  // namespace
