// SPDX-License-Identifier: MIT-0
// A racing car on a track with a tight bend and a wide one.
#include <numbers>

#include "home/scene.h"

namespace {

// The track is the ellipse of a planet, which pulls the car through its bends.
constexpr double a = 10, e = 0.5, lap = 8, h = 0.25;  // [m], 1, [s], [s]
constexpr double omega = 2 * std::numbers::pi / lap;
constexpr int laps = 4, pictures_a_step = 2;

Vec on_track(double angle, double beside) {
  const double b = a * std::sqrt(1 - e * e);
  return {(a + beside) * std::cos(angle) - a * e, (b + beside) * std::sin(angle), 0};
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const double nearest = a * (1 - e), speed = omega * a * std::sqrt((1 + e) / (1 - e));
  const harness::Force bends{harness::Force::orbit, {omega * omega * a * a * a}};
  const judge::Start start{{nearest, 0, 0}, {0, speed, 0}};
  const int steps = static_cast<int>(laps * lap / h);
  const judge::Path mine = yours.run(start, h, steps, 1, bends);
  const judge::Path best = right.run(start, h, steps, 1, bends);
  for (int picture = 0; picture <= steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step);
    stage.picture(h / pictures_a_step);
    for (int cone = 0; cone < 12; ++cone) {
      for (const double beside : {-1.5, 1.5})
        stage.ball("cone", on_track(std::numbers::pi / 6 * cone, beside), 0.15, "scenery");
    }
    stage.trails("car", grade::place(mine, now), grade::place(best, now));
    stage.balls("car", grade::place(mine, now), grade::place(best, now), 0.45);
    stage.label({-5, 0, 0}, "lap " + std::to_string(std::min(laps, 1 + int(now * h / lap))));
  }
}

const grade::Staged staged({
    .exercise = "3-runge-kutta/racing-car",
    .caption =
        "Four laps at four steps a second, which is far coarser than in the game. The pull "
        "through the bends is that of a planet. Kutta's rule, the ring, keeps to the track, but "
        "for what such steps must cost; a slope that is taken at the wrong state drives yours "
        "off its line within a lap.",
    .view = {{-19, -12}, {9, 12}, 2},
    .film = film,
});

}  // namespace
