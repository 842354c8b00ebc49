// SPDX-License-Identifier: MIT-0
// A crate that a hand drags, a strong one and a weak one.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 1.0 / 20;  // [s]
constexpr int steps = 160;

struct Crate {
  const char* name;
  Vec at;  ///< the middle of the hand's path
  double omega, zeta, strongest;
  judge::State yours{}, right{};

  void step(judge::Student& who, judge::State& state, const Vec& hand) const {
    const std::vector<double> next =
        who.call(0, judge::as_numbers(state, h, hand, omega, zeta, strongest), 6);
    state = {{next[0], next[1], next[2]}, {next[3], next[4], next[5]}};
  }
};

Vec hand_at(double t) {
  return {7 * std::sin(1.5 * t), 4 * std::sin(3 * t), 0};
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  Crate crates[] = {{"a strong hand", {0, 0, 0}, 40, 1, 1e5},
                    {"a weak hand", {24, 0, 0}, 8, 0.7, 30}};
  for (int n = 0; n <= steps; ++n) {
    const Vec hand = hand_at(n * h);
    stage.picture(h);
    for (Crate& crate : crates) {
      const Vec mine = crate.at + crate.yours.x, best = crate.at + crate.right.x;
      stage.trails(crate.name, mine, best);
      stage.line(crate.at + hand, mine, "scenery");
      stage.ball("hand", crate.at + hand, 0.35, "scenery");
      stage.boxes(crate.name, mine, best, {1.8, 1.8, 0});
      stage.label(crate.at - Vec{0, 8, 0}, crate.name);
      crate.step(yours, crate.yours, hand_at((n + 1) * h));
      crate.step(right, crate.right, hand_at((n + 1) * h));
    }
  }
}

const grade::Staged staged({
    .exercise = "4-implicit/dragged-crate",
    .caption =
        "Two hands, grey, draw the same figure and drag a crate each, at twenty steps a second. "
        "The strong hand, far too stiff for such steps without a solve, should hold its crate "
        "close by; the weak one, which gives it 30 m/s² at most, lets it swing out. A crate "
        "beside a second frame was pulled wrong, or by more or less than the hand could.",
    .view = {{-10, -9}, {35, 9}},
    .film = film,
});

}  // namespace
