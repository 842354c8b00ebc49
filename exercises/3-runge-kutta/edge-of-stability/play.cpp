// SPDX-License-Identifier: MIT-0
// Lamps on springs, with a step just below your longest one and with one just above it.
#include "home/scene.h"
#include "judge/method.h"

namespace {

constexpr double omega = 10;  // [rad/s]
constexpr int steps = 60;

judge::Path flown(double zeta, double h) {
  const harness::Force spring{harness::Force::spring, {omega, zeta}};
  return judge::run(judge::rk4, {{0, -1, 0}, {}}, h > 0 ? h : 0, steps, 1, spring);
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  struct Lamp {
    std::string name;
    double at;
    judge::Path yours, right;
  };
  std::vector<Lamp> lamps;
  for (const double times : {0.99, 1.01}) {
    for (const double zeta : {0.0, 0.3, 1.5}) {
      const double at = 2.4 * static_cast<double>(lamps.size()) + (times > 1 ? 1 : 0);
      lamps.push_back({"ζ\u00a0=\u00a0" + grade::shown(zeta), at,
                       flown(zeta, times * yours.call(1, {omega, zeta}, 1)[0]),
                       flown(zeta, times * right.call(1, {omega, zeta}, 1)[0])});
    }
  }
  const double limit = right.call(1, {omega, 0}, 1)[0], angle = 0.99 * limit * omega;
  const double mine = yours.call(0, {0, angle}, 1)[0], best = right.call(0, {0, angle}, 1)[0];
  for (std::size_t n = 0; n <= steps; ++n) {
    stage.picture(0.12);
    stage.line({-0.8, 2, 0}, {5.6, 2, 0}, "scenery");
    stage.line({7.4, 2, 0}, {13.8, 2, 0}, "scenery");
    for (const Lamp& lamp : lamps) {
      const Vec hook{lamp.at, 2, 0}, middle{lamp.at, 0, 0};
      const Vec hangs = middle + lamp.yours.states[n].x, ring = middle + lamp.right.states[n].x;
      stage.lines(hook, hangs, ring);
      stage.balls(lamp.name, hangs, ring, 0.22);
      stage.label(hook + Vec{0, 0.4, 0}, lamp.name);
    }
    for (const bool is_yours : {false, true}) {
      const double y = -std::pow(is_yours ? mine : best, static_cast<double>(n));
      stage.line({-0.6, y, 0}, {0.6, y, 0}, is_yours ? "yours" : "true");
    }
    stage.label({2.4, -2.4, 0}, "1 % shorter");
    stage.label({10.6, -2.4, 0}, "1 % longer");
  }
}

const grade::Staged staged({
    .exercise = "3-runge-kutta/edge-of-stability",
    .caption =
        "Lamps on springs by RK4, a picture for each step. On the left the step is 1 % shorter "
        "than your longest one, and all three come to rest; on the right it is 1 % longer, and "
        "all three leave. The rings take the right steps. The level mark on the first spring "
        "falls by your stretch with each step, and the ring there never swings beyond the right "
        "mark.",
    .view = {{-1.4, -2.8}, {14.4, 2.8}},
    .film = film,
});

}  // namespace
