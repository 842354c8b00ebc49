// SPDX-License-Identifier: MIT-0
// The drone of chapter 2, eight seconds a turn.
#include <numbers>

#include "home/scene.h"

namespace {

constexpr double omega = 2 * std::numbers::pi / 8, h = 1.0 / 60;
constexpr int per_picture = 4, turns = 5;

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const judge::Start start{{10, 0, 0}, {0, 10 * omega, 0}};
  const harness::Force leash{harness::Force::spring, {omega, 0}};
  const int steps = turns * 480;
  const judge::Path path = yours.run(start, h, steps, per_picture, leash);
  const judge::Path euler = right.run(start, h, steps, per_picture, leash);
  for (std::size_t n = 0; n < path.states.size(); ++n) {
    const Vec drone = path.states[n].x;
    stage.picture(per_picture * h);
    stage.trails("drone", drone, euler.states[n].x);
    stage.ball("tower", {}, 0.3, "scenery");
    stage.line({}, drone, "scenery");
    stage.balls("drone", drone, euler.states[n].x, 0.4);
    stage.label({0, -15, 0}, grade::shown(length(drone), 4) + " m");
  }
}

const grade::Staged staged({
    .exercise = "2-euler/orbit-drift",
    .caption =
        "Five turns of the drone by your step, at sixty steps a second. Beside it the same by "
        "Euler's method, which lets it drift: a right step lies on its path.",
    .view = {{-17, -17}, {17, 17}, 4},
    .film = film,
});

}  // namespace
