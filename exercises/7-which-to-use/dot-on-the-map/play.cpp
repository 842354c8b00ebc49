// SPDX-License-Identifier: MIT-0
// Things that unknown engines move, with a step just below your longest one and one just above it.
#include "home/scene.h"
#include "scene.h"

namespace {

constexpr double omega = 8, zeta = 0.5, most = 10;  // [rad/s], 1, [s]
constexpr std::size_t engines = 3, steps = 100;
constexpr double farthest = 2.2;  // that is drawn [m]

/// How far from its rest the thing is after each step of an engine.
std::vector<double> moved(const hidden::Step& engine, double h) {
  std::vector<double> places{1};
  double x = 1, v = 0;
  if (!(h > 0 && h <= most)) h = 0;
  const double below = engine.below[0] + h * (engine.below[1] + h * engine.below[2]);
  const auto entry = [&](std::size_t which) {
    double sum = 0;
    for (std::size_t power = 5; power-- > 0;) sum = sum * h + engine.above[which][power];
    return sum / below;
  };
  while (places.size() <= steps) {
    const double x_next = entry(0) * x + entry(1) * v;
    v = entry(2) * x + entry(3) * v;
    x = x_next;
    places.push_back(x);
  }
  return places;
}

struct Thing {
  double at;
  std::vector<double> yours, right;
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  std::vector<hidden::Method> methods = hidden::methods(omega, zeta);
  std::vector<Thing> things;
  double growth = 0, its_growth = 0;
  for (const double times : {0.95, 1.05}) {
    for (std::size_t n = 0; n < engines; ++n) {
      hidden::Step& engine = methods[n].step;
      engine.x_rest = 0.5;
      const double mine = yours.call(1, engine.arguments(most), 1)[0];
      const double best = right.call(1, engine.arguments(most), 1)[0];
      const double at = 2.4 * static_cast<double>(n) + (times > 1 ? 8.2 : 0);
      things.push_back({at, moved(engine, times * mine), moved(engine, times * best)});
      if (things.size() > 1) continue;
      growth = yours.call(0, engine.arguments(times * best), 1)[0];
      its_growth = right.call(0, engine.arguments(times * best), 1)[0];
    }
  }
  for (std::size_t n = 0; n <= steps; ++n) {
    stage.picture(0.07);
    const double power = static_cast<double>(n);
    stage.balls("growth", {-1.1, -std::pow(growth, power), 0},
                {-1.1, -std::pow(its_growth, power), 0}, 0.12);
    for (std::size_t i = 0; i < things.size(); ++i) {
      const Thing& thing = things[i];
      const auto seen = [&](double x) {
        return Vec{thing.at, -std::clamp(x, -farthest, farthest), 0};
      };
      const Vec hook{thing.at, 2.6, 0};
      stage.line(hook - Vec{0.5, 0, 0}, hook + Vec{0.5, 0, 0}, "scenery");
      stage.lines(hook, seen(thing.yours[n]), seen(thing.right[n]));
      stage.balls("thing " + std::to_string(i), seen(thing.yours[n]), seen(thing.right[n]), 0.22);
      stage.label(hook + Vec{0, 0.4, 0}, std::string(1, "ABC"[i % engines]));
    }
    stage.label({2.4, -2.9, 0}, "5 % shorter");
    stage.label({10.6, -2.9, 0}, "5 % longer");
  }
}

const grade::Staged staged({
    .exercise = "7-which-to-use/dot-on-the-map",
    .caption =
        "Three engines move a thing on a spring, a picture for each step. On the left the step "
        "is 5 % shorter than the longest that you find, and all should come to rest; on the "
        "right it is 5 % longer, and all should leave, to be drawn at most 2.2 m out. The dot "
        "beside the first goes to its rest by the growth that you find there. The rings have the "
        "right numbers.",
    .view = {{-1.7, -3.3}, {13.7, 3.4}},
    .film = film,
});

}  // namespace
