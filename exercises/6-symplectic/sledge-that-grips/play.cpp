// SPDX-License-Identifier: MIT-0
// A sledge on a slope, whose runners turn.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 1.0 / 20;  // [s]
constexpr int steps = 160;

/// The slope falls along -y.
Vec runners(double t) {
  const double turned = 1.1 * std::sin(1.3 * t);
  return {std::sin(turned), -std::cos(turned), 0};
}

/// Downhill is to the right in the picture.
Vec seen(const Vec& x) {
  return {-x.y, x.x, 0};
}

struct Sledge {
  judge::State state;

  void step(judge::Student& who, double t) {
    constexpr double along = 1, across = 100;  // [1/s]
    const harness::Force slope{harness::Force::falling, {4}};
    const std::vector<double> next =
        who.call(0, judge::as_numbers(runners(t), along, across, slope, state, t, h, 1, 1), 6);
    state = judge::as_states(next).at(0);
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  Sledge mine, best;
  for (int n = 0; n <= steps; ++n) {
    const Vec sledge = seen(mine.state.x), ring = seen(best.state.x);
    const Vec half = seen(runners(n * h));
    stage.picture(h);
    stage.trails("sledge", sledge, ring);
    for (const Vec& beside : {0.2 * seen(half), -0.2 * seen(half)}) {
      stage.line(ring + beside - half, ring + beside + half, "true");
      stage.line(sledge + beside - half, sledge + beside + half, "yours");
    }
    stage.balls("sledge", sledge, ring, 0.18);
    stage.label({10, -3.6, 0}, grade::shown(length(mine.state.v)) + " m/s");
    mine.step(yours, n * h);
    best.step(right, n * h);
  }
}

const grade::Staged staged({
    .exercise = "6-symplectic/sledge-that-grips",
    .caption =
        "A sledge glides down a slope, which falls to the right, and its runners turn from side "
        "to side, at twenty steps a second. It should follow its runners: one that slips, stops "
        "or explodes brakes by another rule than the ring.",
    .view = {{-1.5, -4.2}, {22, 4.2}},
    .film = film,
});

}  // namespace
