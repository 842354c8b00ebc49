// SPDX-License-Identifier: MIT-0
// A lantern on a chain whose links have play.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 1.0 / 60, shortest = 0.35, longest = 0.5;  // [s], [m]
constexpr int steps = 210, iterations = 10;
constexpr std::size_t links = 6;

struct Chain {
  std::vector<Vec> x, before;
  std::vector<double> inverse;  // masses [1/kg]

  Chain() : inverse(links + 1, 1 / 0.2) {
    for (std::size_t i = 0; i <= links; ++i)
      x.push_back(0.2 * static_cast<double>(i) * Vec{1, 0, 0});  // all links are too short
    inverse.front() = 0;                                         // the ceiling
    inverse.back() = 1 / 3.0;                                    // the lantern
  }

  void pull(judge::Student& who) {
    for (int n = 0; n < iterations; ++n) {
      for (std::size_t i = 0; i < links; ++i) {
        const std::vector<double> ends = who.call(
            0, judge::as_numbers(x[i], x[i + 1], shortest, longest, inverse[i], inverse[i + 1]), 6);
        x[i] = {ends[0], ends[1], ends[2]};
        x[i + 1] = {ends[3], ends[4], ends[5]};
      }
    }
  }

  void step(judge::Student& who) {
    for (std::size_t i = 0; i <= links; ++i) {
      const Vec fall = inverse[i] > 0 ? Vec{0, -9.81, 0} : Vec{};
      const Vec next = x[i] + (x[i] - before[i]) + h * h * fall;
      before[i] = x[i];
      x[i] = next;
    }
    pull(who);
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  Chain mine, best;
  mine.pull(yours);
  best.pull(right);
  mine.before = mine.x;
  best.before = best.x;
  for (int n = 0; n <= steps; ++n) {
    stage.picture(h);
    stage.line({-1, 0, 0}, {1, 0, 0}, "scenery");
    for (std::size_t i = 0; i < links; ++i) {
      stage.line(best.x[i], best.x[i + 1], "true");
      stage.line(mine.x[i], mine.x[i + 1], "yours");
    }
    for (std::size_t i = 1; i <= links; ++i)
      stage.balls("point " + std::to_string(i), mine.x[i], best.x[i], i < links ? 0.06 : 0.2);
    mine.step(yours);
    best.step(right);
  }
}

const grade::Staged staged({
    .exercise = "5-verlet/rope-link",
    .caption =
        "A lantern of 3 kg falls on a chain of six links, whose points weigh 200 g each; a link "
        "may be 0.35 m to 0.5 m long, and at first is put to the shortest. Under your pull it "
        "should move with the chain of rings. One that gives way by halves, or at the ceiling, "
        "stretches under the lantern; one without play, or with one bound alone, hangs another "
        "way.",
    .view = {{-3, -3.6}, {3, 0.6}},
    .film = film,
});

}  // namespace
