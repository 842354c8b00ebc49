// SPDX-License-Identifier: MIT-0
// A throw that is replayed in as few steps as will do.
#include "format_values.h"
#include "home/scene.h"
#include "judge/method.h"

namespace {

constexpr double duration = 2, wanted = 0.1;  // [s], [m]
constexpr int pictures = 100;
constexpr double rim = 2.5;  // of the glass [m]
const Vec glass{9, 2, 0};

/// A replay, and how far it is from the truth.
struct Replay {
  std::vector<Vec> x, off;

  Replay(judge::Student& who, const judge::Start& start, const harness::Force& force) {
    const judge::Start asked{start.x, start.v, wanted};
    const double got = who.run(asked, duration, 1, 1, force).states[1].x.x;
    const int steps = static_cast<int>(grade::within(got, 1, 3000));
    const judge::Path path = judge::run(judge::euler, start, duration / steps, steps, 1, force);
    const judge::Path truth = judge::truth(start, duration / steps, steps, 1, force);
    for (std::size_t n = 0; n < path.states.size(); ++n) {
      x.push_back(path.states[n].x);
      off.push_back(path.states[n].x - truth.states[n].x);
    }
  }

  std::size_t steps() const { return x.size() - 1; }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const judge::Start start{{0, 0, 0}, {11, 13, 0}};
  const harness::Force force{harness::Force::falling, {9.81, 0, 0.02}};
  const Replay mine(yours, start, force), best(right, start, force);
  for (std::size_t picture = 0; picture <= pictures; ++picture) {
    const std::size_t n = picture * mine.steps() / pictures, m = picture * best.steps() / pictures;
    stage.picture(duration / pictures);
    stage.trails("thrown", mine.x[n], best.x[m]);
    stage.balls("thrown", mine.x[n], best.x[m], 0.3);
    stage.ball("glass", glass, rim, "scenery");
    stage.balls("off", glass + rim / wanted * mine.off[n], glass + rim / wanted * best.off[m], 0.2);
    stage.label(glass - Vec{0, rim + 0.7, 0}, "25 times as large");
    const double metres = 15.0 / static_cast<double>(best.steps());
    const Vec bar{0, -3, 0};
    stage.lines(bar, bar + Vec{metres * static_cast<double>(n), 0, 0},
                bar + Vec{metres * static_cast<double>(m), 0, 0});
    stage.label(bar + Vec{7.5, -0.8, 0}, grade::counted(mine.steps(), "step"));
  }
}

const grade::Staged staged({
    .exercise = "2-euler/steps-you-can-afford",
    .caption =
        "A throw of two seconds by Euler's method, in as many steps as yours says. The grey "
        "glass shows, 25 times as large, how far it is from the truth in its middle; its rim is "
        "the wanted error of 0.1 m, and at the end your dot should be just inside. The bar below "
        "grows with the steps: one that is longer than the right one costs more than it must.",
    .view = {{-1, -4.6}, {20, 9.6}, 0.5},
    .film = film,
});

}  // namespace
