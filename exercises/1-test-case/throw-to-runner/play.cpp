// SPDX-License-Identifier: MIT-0
// Robots throw balls to their mates.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

struct Throw {
  const char* name;
  Vec from, target, runner, a;

  Vec velocity(judge::Student& who, double time) const {
    const std::vector<double> way =
        who.call(0, judge::as_numbers(from, target, runner, a, time), 3);
    return {way[0], way[1], way[2]};
  }
};

constexpr double time = 1.6;  // of the flight [s]
constexpr Throw throws[] = {
    {"standing", {0, 11.2, 0}, {11, 11.2, 0}, {0, 0, 0}, {0, -9.81, 0}},
    {"running", {0, 5.6, 0}, {7, 5.6, 0}, {5, 0, 0}, {0, -9.81, 0}},
    {"running, in a wind", {1, 0, 0}, {14, 0, 0}, {-4, 0, 0}, {-6, -9.81, 0}},
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  constexpr int flight = 64, pictures = flight + 20;
  for (int picture = 0; picture <= pictures; ++picture) {
    const double t = time * std::min(picture, flight) / flight;
    stage.picture(time / flight);
    for (const Throw& one : throws) {
      const Vec fallen = one.from + t * t / 2 * one.a, mate = one.target + t * one.runner;
      const Vec ball = fallen + t * one.velocity(yours, time);
      const Vec best = fallen + t * one.velocity(right, time);
      stage.line(one.from - Vec{2, 1, 0}, {16, one.from.y - 1, 0}, "scenery");
      for (const Vec& robot : {one.from - Vec{0.4, 0, 0}, mate}) {
        stage.line(robot - Vec{0, 1, 0}, robot, "scenery");
        stage.ball("robot", robot + Vec{0, 0.3, 0}, 0.3, "scenery");
      }
      stage.trails(one.name, ball, best);
      stage.balls(one.name, ball, best, 0.2);
      stage.label(Vec{7.5, one.from.y - 1.65, 0},
                  std::string(one.name) + ": " + grade::shown(length(ball - mate), 2) + " m away");
    }
  }
}

const grade::Staged staged({
    .exercise = "1-test-case/throw-to-runner",
    .caption =
        "Three robots throw, half as fast as in the game, and each flight lasts 1.6 s. The ball "
        "that leaves with your velocity lies in the ring, which meets the mate. With a wrong one "
        "it flies another way, and ends where nobody is.",
    .view = {{-1.5, -2.4}, {16, 15}, 0.5},
    .film = film,
});

}  // namespace
