// SPDX-License-Identifier: MIT-0
// Leaves in a whirlwind that crosses a park.
#include "home/scene.h"

namespace {

constexpr double h = 1.0 / 30, c = 200, turns = 3;  // [s], [1/s], [rad/s]
constexpr int steps = 210;

Vec middle(double t) {
  return {2 * t - 7, std::sin(t), 0};
}

/// It turns like a wheel, and its middle moves on.
Vec wind(const Vec& x, double t) {
  const Vec from = x - middle(t);
  return {2 - turns * from.y, std::cos(t) + turns * from.x, 0};
}

judge::Path drifted(judge::Student& who, double radius) {
  const Vec x = middle(0) + Vec{radius, 0, 0};
  who.call(0, {c}, 0);
  return who.watch(
      {x, wind(x, 0)}, h, steps,
      [](const Vec& place, const Vec&, double t) { return wind(place, t); }, 1);
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  std::vector<judge::Path> mine, best;
  for (const double radius : {1.0, -1.6, 2.2}) {
    mine.push_back(drifted(yours, radius));
    best.push_back(drifted(right, radius));
  }
  for (std::size_t n = 0; n <= steps; ++n) {
    stage.picture(h);
    stage.ball("whirlwind", middle(static_cast<double>(n) * h), 0.15, "scenery");
    for (std::size_t leaf = 0; leaf < mine.size(); ++leaf) {
      const std::string name = "leaf " + std::to_string(leaf);
      stage.trails(name, mine[leaf].states[n].x, best[leaf].states[n].x);
      stage.balls(name, mine[leaf].states[n].x, best[leaf].states[n].x, 0.2);
    }
  }
}

const grade::Staged staged({
    .exercise = "4-implicit/leaf-in-the-wind",
    .caption =
        "Three leaves in a whirlwind that crosses the park, at thirty frames a second. The grey "
        "dot is its middle. The rings and their paths are leaves that ask in the middle of the "
        "frame. Leaves that ask for the wind at its start are led outwards, turn by turn.",
    .view = {{-11, -5}, {11, 5}},
    .film = film,
});

}  // namespace
