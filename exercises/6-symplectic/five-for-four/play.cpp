// SPDX-License-Identifier: MIT-0
// A probe that coasts around a sun, past a planet.
#include <numbers>

#include "home/scene.h"

namespace {

constexpr double a = 10, e = 0.4, period = 8;  // [m], 1, [s]
constexpr double omega = 2 * std::numbers::pi / period, mu = omega * omega * a * a * a;
constexpr double h = period / 24;
constexpr int steps = 8 * 24, pictures_a_step = 2;

Vec planet(double t) {
  return {17 * std::cos(0.3 * t), 17 * std::sin(0.3 * t), 0};
}

Vec pull(const Vec& to, double strength) {
  const double r = length(to);
  return strength / (r * r * r) * to;
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const judge::Start start{{a * (1 - e), 0, 0}, {0, omega * a * std::sqrt((1 + e) / (1 - e)), 0}};
  const Acceleration sky = [](const Vec& x, const Vec&, double t) {
    return pull(-x, mu) + pull(planet(t) - x, 0.004 * mu);
  };
  const judge::Path mine = yours.watch(start, h, steps, sky);
  const judge::Path best = right.watch(start, h, steps, sky);
  for (int picture = 0; picture <= steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step);
    stage.picture(h / pictures_a_step);
    stage.trails("probe", grade::place(mine, now), grade::place(best, now));
    stage.ball("sun", {}, 0.8, "scenery");
    stage.ball("planet", planet(now * h), 0.5, "scenery");
    stage.balls("probe", grade::place(mine, now), grade::place(best, now), 0.4);
  }
}

const grade::Staged staged({
    .exercise = "6-symplectic/five-for-four",
    .caption =
        "Eight turns of a probe around its sun, in 24 steps a turn, while a planet tugs at it "
        "from further out. The ring takes Suzuki's five parts. Other parts, or a clock that does "
        "not go along with them, lead yours to another place.",
    .view = {{-18, -18}, {18, 18}, 6},
    .film = film,
});

}  // namespace
