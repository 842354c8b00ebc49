// SPDX-License-Identifier: MIT-0
// A speedometer on a fast screen and on a slow one.
#include <numbers>

#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double tick = 1.0 / 60, omega = 6;  // [s], [rad/s]
constexpr int ticks = 7 * 60;

/// The speed of the car [10 km/h], and how fast it changes [10 km/h per second].
struct Speed {
  double target, u;
};

Speed car(double t) {
  if (t < 2) return {4 * t, 4};
  if (t < 3) return {8, 0};
  if (t < 4) return {8 - 6 * (t - 3), -6};
  return t < 5.5 ? Speed{9, 0} : Speed{3, 0};
}

/// Where the needle points at each tick, on a screen whose frames last so many.
std::vector<double> pointed(judge::Student& who, const std::vector<int>& frames) {
  std::vector<double> asked;
  std::vector<int> lasted;
  for (int now = 0; now < ticks; now += lasted.back()) {
    lasted.push_back(frames[lasted.size() % frames.size()]);
    const Speed speed = car(now * tick + 1e-9);
    judge::append(asked, std::vector{speed.target, speed.u, lasted.back() * tick});
  }
  std::vector<double> all = judge::as_numbers(0, 0, omega, lasted.size(), asked);
  const std::vector<double> answer = who.call(0, all, 2 * lasted.size());
  std::vector<double> points;
  double x = 0;
  for (std::size_t n = 0; n < lasted.size(); ++n) {
    points.insert(points.end(), static_cast<std::size_t>(lasted[n]), x);
    x = answer[2 * n];
  }
  return points;
}

Vec on_dial(double speed, double radius) {
  const double angle = std::numbers::pi * (1.2 - 0.14 * speed);
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  struct Screen {
    const char* name;
    double lane;
    std::vector<int> frames;
  };
  const Screen screens[] = {{"60 Hz", 3.4, {1}}, {"a slow screen", 0, {6, 12, 4, 8}}};
  std::vector<std::vector<double>> mine, best;
  for (const Screen& screen : screens) {
    mine.push_back(pointed(yours, screen.frames));
    best.push_back(pointed(right, screen.frames));
  }
  for (std::size_t now = 0; now < ticks; now += 2) {
    const double t = static_cast<double>(now) * tick, target = car(t + 1e-9).target;
    stage.picture(2 * tick);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Vec hub{0, screens[n].lane, 0};
      const auto pen = [&](double speed) { return hub + Vec{2.2 + t, 0.2 * speed - 0.8, 0}; };
      for (int speed = 0; speed <= 10; speed += 2)
        stage.line(hub + on_dial(speed, 1.3), hub + on_dial(speed, 1.45), "scenery");
      stage.ball("target", hub + on_dial(target, 1.38), 0.12, "scenery");
      stage.trail(std::string("target ") + screens[n].name, pen(target), "scenery");
      stage.trails(screens[n].name, pen(mine[n][now]), pen(best[n][now]));
      stage.lines(hub, hub + on_dial(mine[n][now], 1.2), hub + on_dial(best[n][now], 1.2));
      stage.ball("hub", hub, 0.1, "scenery");
      stage.label(hub + Vec{5.7, -1.2, 0}, screens[n].name);
    }
  }
}

const grade::Staged staged({
    .exercise = "7-which-to-use/needle-that-settles",
    .caption =
        "A speedometer on a fast screen and on a slow one with frames of 67 ms to 200 ms. The "
        "grey dot is the speed of the car, which rises and falls evenly, and then jumps; beside "
        "the dial it is written down. Your needle should trail it as the right one does, and on "
        "the slow screen only move less often.",
    .view = {{-1.7, -1.6}, {9.4, 5.1}},
    .film = film,
});

}  // namespace
