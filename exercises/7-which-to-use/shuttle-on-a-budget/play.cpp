// SPDX-License-Identifier: MIT-0
// A shuttle that may ask for the acceleration 1200 times.
#include <numbers>

#include "home/scene.h"
#include "judge/method.h"

namespace {

constexpr double e = 0.8, mu = 1, seconds = 3.2 * std::numbers::pi;  // [m^3/s^2], [s]
constexpr double enlarged = 10;                                      // an orbit of half axis 1 m
constexpr int budget = 1200, pictures = 150;
constexpr std::size_t dot_every = 24;  // questions
constexpr double rim = 3;              // of the glass [m]
const Vec glass{8, 0, 0};

const judge::Start start{{1 - e, 0, 0}, {0, std::sqrt((1 + e) / (1 - e)), 0}};

Vec pull(const Vec& x, const Vec&, double t) {
  const double r2 = dot(x, x), r = std::sqrt(r2);
  const Vec moon{0.01 * std::cos(t), 0.01 * std::sin(t), 0};
  return (-mu / (r2 * r) * (1 + 0.002 / r2)) * x + moon;
}

struct Flight {
  std::vector<Vec> asked;
  std::size_t questions = 0;
  Vec end;

  explicit Flight(judge::Student& who) {
    constexpr std::size_t patience = 15000;  // after which nothing pulls
    const Acceleration counted = [this](const Vec& x, const Vec& v, double t) {
      if (questions < budget) asked.push_back(enlarged * x);
      return ++questions > patience ? Vec{} : pull(x, v, t);
    };
    end = who.watch(start, seconds, 1, counted).states[1].x;
    if (asked.empty()) asked.push_back(enlarged * start.x);
  }

  /// Where it was when it had asked this share of its questions.
  std::size_t at(double share) const {
    return static_cast<std::size_t>(share * static_cast<double>(asked.size() - 1));
  }

  void draw_dots(grade::Stage& stage, double share, const std::string& colour) const {
    for (std::size_t n = 0; n < at(share); n += dot_every)
      stage.ball("", asked[n], colour == "true" ? 0.15 : 0.1, colour);
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const Flight mine(yours), best(right);
  const Vec truth = judge::truth_past_a_sun(start, seconds, mu, pull).x;
  constexpr int equal = budget / 4;
  const judge::Path rk4 = judge::run(judge::rk4, start, seconds / equal, equal, equal, pull);
  const double limit = length(rk4.states.back().x - truth) / 20;
  const auto in_glass = [&](const Vec& end) {
    const Vec off = rim / limit * (end - truth);
    const double farthest = 1.3 * rim;
    return glass + (length(off) > farthest ? farthest / length(off) * off : off);
  };
  for (int picture = 0; picture <= pictures; ++picture) {
    const double share = picture / double(pictures);
    const Vec &shuttle = mine.asked[mine.at(share)], &ring = best.asked[best.at(share)];
    stage.picture(0.05);
    stage.ball("planet", {}, 0.8, "scenery");
    best.draw_dots(stage, share, "true");
    mine.draw_dots(stage, share, "yours");
    stage.balls("shuttle", shuttle, ring, 0.35);
    stage.ball("glass", glass, rim, "scenery");
    stage.balls("end", in_glass(mine.end), in_glass(best.end), 0.25);
    stage.label(glass - Vec{0, rim + 1.2, 0}, grade::shown(length(mine.end - truth), 2) + " m off");
    stage.label({-8, -8.2, 0}, std::to_string(mine.questions) + " questions");
  }
}

const grade::Staged staged({
    .exercise = "7-which-to-use/shuttle-on-a-budget",
    .caption =
        "A dive past the planet and out again, in the order in which you ask: the shuttle is "
        "where your code asks for the acceleration, each 24th question leaves a dot, and what "
        "comes after 1200 is not shown. The glass has the true end in its middle, and its rim is "
        "a twentieth of the error of RK4 in equal steps at that price: your dot should be "
        "inside, as the ring is.",
    .view = {{-20, -9}, {13, 8}},
    .film = film,
});

}  // namespace
