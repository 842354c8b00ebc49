// SPDX-License-Identifier: MIT-0
// A chain of beads that is let go.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 1.0 / 60;  // [s]
constexpr int steps = 240;
constexpr std::size_t beads = 12;

struct Chain {
  std::vector<double> x, v = std::vector<double>(beads), k;

  Chain() {
    for (std::size_t i = 0; i < beads; ++i) {
      x.push_back(0.3 * static_cast<double>(i + 1));
      k.push_back(i % 3 == 0 ? 6000 : 400);
    }
  }

  void step(judge::Student& who) {
    const std::vector<double> next =
        who.call(0, judge::as_numbers(static_cast<double>(beads), h, x, v, k), 2 * beads);
    x.assign(next.begin(), next.begin() + beads);
    v.assign(next.begin() + beads, next.end());
  }

  Vec bead(std::size_t i) const { return {static_cast<double>(i + 1), x[i], 0}; }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  Chain mine, best;
  for (int n = 0; n <= steps; ++n) {
    stage.picture(h);
    stage.line({0, -3.6, 0}, {0, 3.6, 0}, "scenery");
    for (const auto& [chain, colour] : {std::pair{&best, "true"}, {&mine, "yours"}}) {
      Vec before{};
      for (std::size_t i = 0; i < beads; before = chain->bead(i++))
        stage.line(before, chain->bead(i), colour);
    }
    for (std::size_t i = 0; i < beads; ++i)
      stage.balls("bead " + std::to_string(i), mine.bead(i), best.bead(i), 0.16);
    mine.step(yours);
    best.step(right);
  }
}

const grade::Staged staged({
    .exercise = "4-implicit/chain-of-beads",
    .caption =
        "A chain of twelve beads is drawn out and let go, at sixty steps a second. How far each "
        "bead is from its place is drawn upwards, so that you see the wave run; every third "
        "spring is stiff. Your beads should stay within the rings: with a wrong matrix, or none, "
        "the chain takes another shape.",
    .view = {{-0.6, -4.2}, {12.6, 4.2}},
    .film = film,
});

}  // namespace
