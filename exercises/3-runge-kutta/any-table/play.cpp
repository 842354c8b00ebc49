// SPDX-License-Identifier: MIT-0
// A drone on its leash, in gusts that turn, by three tables.
#include <numbers>

#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double omega = 2 * std::numbers::pi / 8, h = 0.5;  // [rad/s], [s]
constexpr int steps = 48, pictures_a_step = 3;

struct Table {
  const char* name;
  std::vector<std::vector<double>> parts;
  std::vector<double> weights;

  judge::Path flown(judge::Student& who) const {
    std::vector<double> numbers{static_cast<double>(parts.size())};
    for (const std::vector<double>& row : parts) judge::append(numbers, row);
    judge::append(numbers, weights);
    who.call(0, numbers, 0);
    const Acceleration leash_and_gusts = [](const Vec& x, const Vec&, double t) {
      return -omega * omega * x + Vec{std::cos(2 * t), std::sin(3 * t), 0};
    };
    return who.watch({{10, 0, 0}, {0, 10 * omega, 0}}, h, steps, leash_and_gusts, 1);
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const Table tables[] = {
      {"midpoint", {{}, {0.5}}, {0, 1}},
      {"RK4", {{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}},
      {"Dormand–Prince",
       {{},
        {1.0 / 5},
        {3.0 / 40, 9.0 / 40},
        {44.0 / 45, -56.0 / 15, 32.0 / 9},
        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}},
       {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}},
  };
  std::vector<judge::Path> mine, best;
  for (const Table& table : tables) {
    mine.push_back(table.flown(yours));
    best.push_back(table.flown(right));
  }
  for (int picture = 0; picture <= steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step);
    stage.picture(h / pictures_a_step);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Vec tower{34 * static_cast<double>(n), 0, 0};
      const Vec drone = tower + grade::place(mine[n], now),
                ring = tower + grade::place(best[n], now);
      stage.trails(tables[n].name, drone, ring);
      stage.ball("tower", tower, 0.5, "scenery");
      stage.line(tower, drone, "scenery");
      stage.balls(tables[n].name, drone, ring, 0.9);
      stage.label(tower - Vec{0, 18, 0}, tables[n].name);
    }
  }
}

const grade::Staged staged({
    .exercise = "3-runge-kutta/any-table",
    .caption =
        "Three turns of a drone on its leash, in gusts that change with time, at two steps a "
        "second. One function of yours flies all three, each by the table of a method. It should "
        "follow the ring, which is the right function: a stage that takes the wrong slope, or "
        "asks at the wrong time, leads it off.",
    .view = {{-16, -20}, {84, 16}, 4},
    .film = film,
});

}  // namespace
