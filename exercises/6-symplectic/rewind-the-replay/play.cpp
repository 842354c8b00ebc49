// SPDX-License-Identifier: MIT-0
// A car that drives, and is rewound.
#include "home/scene.h"

namespace {

constexpr double h = 0.1;  // [s]
constexpr int steps = 50, pictures_a_step = 3;

Vec push(const Vec& x, const Vec&, double t) {
  return {-3 * x.x + 2 * std::sin(4 * t), -9 * x.y + 3 * std::cos(5 * t), 0};
}

/// There, and back to where it began.
judge::Path driven(judge::Student& who, const judge::Start& start) {
  judge::Path path = who.watch(start, h, steps, push);
  const judge::State end = path.states.back();
  const judge::Path back = who.watch({end.x, end.v, steps * h}, -h, steps, push, 1);
  path.states.insert(path.states.end(), back.states.begin() + 1, back.states.end());
  return path;
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const judge::Start start{{6, 0, 0}, {0, 9, 0}};
  const judge::Path mine = driven(yours, start), best = driven(right, start);
  for (int picture = 0; picture <= 2 * steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step);
    const Vec car = grade::place(mine, now);
    stage.picture(h / pictures_a_step);
    stage.ball("start", start.x, 0.5, "scenery");
    stage.trails("car", car, grade::place(best, now));
    stage.balls("car", car, grade::place(best, now), 0.28);
    stage.label({0, -5, 0}, now < steps ? "forward" : "rewind");
    const double off = std::round(1000 * length(car - start.x)) / 1000;
    stage.label({0, 5, 0}, grade::shown(off) + " m from the start");
  }
}

const grade::Staged staged({
    .exercise = "6-symplectic/rewind-the-replay",
    .caption =
        "A car drives for five seconds by your step, and is rewound by your undo, at ten steps a "
        "second. On its way back it should draw no new line, and end on the grey disc from which "
        "it set out. The ring does.",
    .view = {{-8, -5.6}, {8, 5.6}},
    .film = film,
});

}  // namespace
