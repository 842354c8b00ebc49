// SPDX-License-Identifier: MIT-0
// Two curtains, hung up by your plan.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr int links = 30, seconds = 15, frames_a_picture = 3;
constexpr double frame = 1.0 / 30, most = 0.05;  // [s], [m]
constexpr double gravity = 9.81, link = 0.1;     // [m/s^2], [m]
constexpr double enlarged = 20;                  // the stretch, to be seen

struct Plan {
  int substeps = 1, iterations = 1;

  double price(double move, double pull) const { return substeps * (move + iterations * pull); }
};

Plan plan(judge::Student& who, double move, double pull) {
  const std::vector<double> got = who.call(1, judge::as_numbers(links, frame, most, move, pull), 2);
  return {static_cast<int>(grade::within(got[0], 1, 60)),
          static_cast<int>(grade::within(got[1], 1, 100))};
}

double stretch(judge::Student& who, const Plan& plan) {
  return who.call(0, judge::as_numbers(links, frame, plan.substeps, plan.iterations), 1)[0];
}

/// A rope that hangs straight down: how far each of its points is too low [m].
struct Rope {
  Plan plan{};
  std::vector<double> excess = std::vector<double>(links + 1), previous = excess;

  void step() {
    const double h = frame / plan.substeps;
    for (int substep = 0; substep < plan.substeps; ++substep) {
      for (std::size_t i = 1; i <= links; ++i) {
        const double next = 2 * excess[i] - previous[i] + gravity * h * h;
        previous[i] = excess[i];
        excess[i] = next;
      }
      for (int k = 0; k < plan.iterations; ++k) {
        excess[1] = 0;
        for (std::size_t i = 2; i <= links; ++i)
          excess[i] = excess[i - 1] = (excess[i] + excess[i - 1]) / 2;
      }
    }
  }

  double depth(std::size_t i) const { return link * static_cast<double>(i) + enlarged * excess[i]; }
};

struct Curtain {
  const char* game;
  double at, move, pull;  // where it hangs [m], and prices [us]
  Rope yours{}, right{};
  double foretold = 0, told = 0;  // by yours and by the right rule, of the right plan [m]

  void hang_up(judge::Student& mine, judge::Student& best) {
    yours.plan = plan(mine, move, pull);
    right.plan = plan(best, move, pull);
    foretold = stretch(mine, right.plan);
    told = stretch(best, right.plan);
  }

  Vec place(double across, double depth) const { return {at + across, -depth, 0}; }

  void draw(grade::Stage& stage) const {
    constexpr double width = 2.4, length = link * links, limit = length + enlarged * most;
    for (const double depth : {0.0, limit})
      stage.line(place(-width, depth), place(width, depth), "scenery");
    for (const auto& [rope, colour] : {std::pair{&right, "true"}, {&yours, "yours"}}) {
      const double hem = rope->depth(links);
      for (const double across : {-2.0, -1.0, 0.0, 1.0, 2.0})
        stage.line(place(across, 0), place(across, hem), colour);
      stage.line(place(-2, hem), place(2, hem), colour);
    }
    for (std::size_t i = 5; i <= links; i += 5)
      stage.balls("point " + std::to_string(i), place(0, yours.depth(i)), place(0, right.depth(i)),
                  0.07);
    stage.balls("foretold", place(width + 0.3, length + enlarged * foretold),
                place(width + 0.3, length + enlarged * told), 0.09);
    const double share = yours.plan.price(move, pull) / right.plan.price(move, pull);
    const Vec bar = place(-width, limit + 0.5);
    stage.lines(bar, bar + Vec{2 * width * share, 0, 0}, bar + Vec{2 * width, 0, 0});
    stage.label(place(0, -0.4), std::string(game) + ": " + std::to_string(yours.plan.substeps) +
                                    " × " + std::to_string(yours.plan.iterations));
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  Curtain curtains[] = {{"cheap moves", 0, 0.1, 0.1}, {"dear moves", 7, 1, 0.1}};
  for (Curtain& curtain : curtains) curtain.hang_up(yours, right);
  for (int picture = 0; picture * frames_a_picture * frame < seconds; ++picture) {
    stage.picture(frames_a_picture * frame);
    for (Curtain& curtain : curtains) {
      curtain.draw(stage);
      for (int n = 0; n < frames_a_picture; ++n) {
        curtain.yours.step();
        curtain.right.step();
      }
    }
  }
}

const grade::Staged staged({
    .exercise = "5-verlet/pulls-for-a-curtain",
    .caption =
        "Two curtains bounce and come to rest, each with the substeps and iterations of your "
        "plan; what they stretch is drawn twenty times as large. At rest the hem should hang "
        "just above the grey line: a plan that is too cheap lets it sink below. The dot at the "
        "side is the stretch that your rule foretells for the right plan, and the bar below is "
        "what a frame of yours costs. The rings, and what yours does not cover, are right.",
    .view = {{-3.2, -5.1}, {10.2, 0.8}, 3},
    .film = film,
});

}  // namespace
