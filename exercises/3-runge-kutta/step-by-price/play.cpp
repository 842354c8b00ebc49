// SPDX-License-Identifier: MIT-0
// A comet's pass by the sun, and where its path was asked for.
#include "home/scene.h"

namespace {

constexpr double duration = 12, tolerance = 1e-3, mu = 100;  // [s], [m], [m^3/s^2]
constexpr int pictures = 100, most_dots = 64;
enum Function { told_tolerance, flies, passes };

const judge::Start start{{-24, 5, 0}, {4, 0, 0}};

const harness::Force& sun() {
  static const harness::Force pull{harness::Force::orbit, {mu}};
  return pull;
}

struct Comet {
  std::vector<Vec> x{start.x};
  judge::Path asked;
  Vec nearest;
};

Comet flown(judge::Student& who, judge::Student& right) {
  constexpr int patience = 15000;  // questions, after which nothing pulls
  int questions = 0;
  const Acceleration counted = [&](const Vec& x, const Vec& v, double t) {
    return ++questions > patience ? Vec{} : sun()(x, v, t);
  };
  who.call(told_tolerance, {tolerance}, 0);
  right.call(told_tolerance, {tolerance}, 0);
  Comet comet;
  comet.asked = who.watch(start, duration, 1, counted, flies);
  // Each from the start, so that no flight goes on from a place that is no number.
  for (int n = 1; n <= pictures; ++n)
    comet.x.push_back(who.run(start, n * duration / pictures, 1, 1, sun(), flies).states[1].x);
  const double moment = who.run(start, duration, 1, 1, sun(), passes).states[1].x.x;
  const double within = grade::within(moment, 0.01, duration);
  comet.nearest = right.run(start, within, 1, 1, sun(), flies).states[1].x;
  return comet;
}

void draw_asked(grade::Stage& stage, const judge::Path& asked, double until,
                const std::string& colour) {
  const std::size_t every = 1 + asked.evaluations.size() / most_dots;
  for (std::size_t n = 0; n < asked.evaluations.size(); n += every) {
    const judge::Evaluation& one = asked.evaluations[n];
    if (one.t <= until) stage.ball("", one.x, colour == "true" ? 0.2 : 0.14, colour);
  }
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const Comet mine = flown(yours, right), best = flown(right, right);
  const std::string questions = std::to_string(mine.asked.evaluations.size()) + " questions";
  for (std::size_t n = 0; n <= pictures; ++n) {
    const double now = static_cast<double>(n) * duration / pictures;
    stage.picture(duration / pictures);
    stage.ball("sun", {}, 0.7, "scenery");
    stage.lines({}, 2.5 * mine.nearest, 2.5 * best.nearest);
    stage.trails("comet", mine.x[n], best.x[n]);
    draw_asked(stage, best.asked, now, "true");
    draw_asked(stage, mine.asked, now, "yours");
    stage.balls("comet", mine.x[n], best.x[n], 0.5);
    stage.label({-8, 7, 0}, questions);
  }
}

const grade::Staged staged({
    .exercise = "3-runge-kutta/step-by-price",
    .caption =
        "A comet passes the sun, with a tolerance of a millimetre. The small dots are places at "
        "which one flight asks for the acceleration, every so many of them: they should crowd "
        "near the sun and be rare far out. The line from the sun points to where the comet is at "
        "the moment that your nearest names. Where a second path shows, the right flight goes "
        "elsewhere.",
    .view = {{-25, -12}, {10, 8}, 2},
    .film = film,
});

}  // namespace
