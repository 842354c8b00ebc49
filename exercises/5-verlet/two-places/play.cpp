// SPDX-License-Identifier: MIT-0
// Sparks that fly from a grinder and bounce.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 1.0 / 30, restitution = 0.6;  // [s]
constexpr int steps = 80;
const Vec gravity{0, -9.81, 0}, grinder{0, 1.5, 0};
enum Function { next_place = 1, place_before, bounce };

struct Spark {
  Vec x, before;

  Spark(judge::Student& who, const Vec& v) : x(grinder) {
    const std::vector<double> place =
        who.call(place_before, judge::as_numbers(x, v, gravity, h), 3);
    before = {place[0], place[1], place[2]};
  }

  void step(judge::Student& who) {
    const std::vector<double> place =
        who.call(next_place, judge::as_numbers(x, before, gravity, h), 3);
    const Vec next{place[0], place[1], place[2]};
    const std::vector<double> both =
        who.call(bounce, judge::as_numbers(next, x, 0, restitution), 6);
    x = {both[0], both[1], both[2]};
    before = {both[3], both[4], both[5]};
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  std::vector<Spark> mine, best;
  for (const Vec& v : {Vec{1, 5, 0}, Vec{2, 3, 0}, Vec{3, 6, 0}, Vec{4, 1, 0}}) {
    mine.emplace_back(yours, v);
    best.emplace_back(right, v);
  }
  for (int n = 0; n <= steps; ++n) {
    stage.picture(h);
    stage.line({-1, 0, 0}, {11, 0, 0}, "scenery");
    stage.ball("grinder", grinder - Vec{0.5, 0, 0}, 0.45, "scenery");
    for (std::size_t i = 0; i < mine.size(); ++i) {
      const std::string name = "spark " + std::to_string(i);
      stage.trails(name, mine[i].x, best[i].x);
      stage.balls(name, mine[i].x, best[i].x, 0.1);
      mine[i].step(yours);
      best[i].step(right);
    }
  }
}

const grade::Staged staged({
    .exercise = "5-verlet/two-places",
    .caption =
        "Four sparks fly from a grinder, at thirty steps a second, and keep 0.6 of their speed "
        "up and down when they bounce. A place before that is not the true one sends a spark off "
        "at another speed; a bounce that tells the two places wrong is seen at the floor. The "
        "paths of the rings are right.",
    .view = {{-1.2, -0.5}, {11, 4}, 0.5},
    .film = film,
});

}  // namespace
