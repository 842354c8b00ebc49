// SPDX-License-Identifier: MIT-0
// A camera that follows a car on a damped spring.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double h = 0.1, omega = 15;  // [s], [rad/s]
constexpr int steps = 80, pictures_a_step = 3;

Vec car(double t) {
  return {10 - 9 * std::cos(0.8 * t), 0, 0};
}

judge::Path followed(judge::Student& who, double zeta) {
  judge::Path path{.h = h, .states = {{car(0), {}}}, .evaluations = {}};
  Vec x = car(0), before = x;
  for (int n = 0; n < steps; ++n) {
    const Vec push = omega * omega * (car(n * h) - x);
    const std::vector<double> next =
        who.call(1, judge::as_numbers(x, before, push, 2 * zeta * omega, h), 3);
    before = x;
    x = {next[0], next[1], next[2]};
    path.states.push_back({x, {}});
  }
  return path;
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  struct Camera {
    const char* name;
    double zeta, lane;
  };
  constexpr Camera cameras[] = {
      {"a light damper", 0.2, 8}, {"a critical one", 1, 4}, {"a heavy one", 4, 0}};
  std::vector<judge::Path> mine, best;
  for (const Camera& camera : cameras) {
    mine.push_back(followed(yours, camera.zeta));
    best.push_back(followed(right, camera.zeta));
  }
  for (int picture = 0; picture <= steps * pictures_a_step; ++picture) {
    const double now = picture / double(pictures_a_step);
    stage.picture(h / pictures_a_step);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Vec lane{0, cameras[n].lane, 0};
      stage.line(lane - Vec{1.5, 0.35, 0}, lane + Vec{21.5, -0.35, 0}, "scenery");
      stage.box("car", lane + car(now * h), {1.4, 0.7, 0}, "scenery");
      stage.boxes(cameras[n].name, lane + grade::place(mine[n], now),
                  lane + grade::place(best[n], now), {3.2, 2, 0});
      stage.label(lane + Vec{10, -1.7, 0}, cameras[n].name);
    }
  }
}

const grade::Staged staged({
    .exercise = "5-verlet/braked-verlet",
    .caption =
        "Three cameras, the larger frames, follow a grey car on damped springs, in steps of a "
        "tenth of a second, at which hω is 1.5. None of them should shake: with the velocity of "
        "now, a heavy damper holds as a light one does. Where a second frame shows beside yours, "
        "the drag is another.",
    .view = {{-2.5, -2.5}, {22.5, 10}},
    .film = film,
});

}  // namespace
