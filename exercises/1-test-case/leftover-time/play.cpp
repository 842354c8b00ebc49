// SPDX-License-Identifier: MIT-0
// A ball that hops along on three screens, in slow motion for a while.
#include "home/scene.h"

namespace {

constexpr double h = 1.0 / 60;  // [s]
constexpr int seconds = 5, pictures = 60 * seconds;

bool is_slow(double time) {
  return time > 1.5 && time < 3.5;
}

/// The game time that is drawn after each frame.
std::vector<double> drawn(judge::Student& who, int rate) {
  const int frames = seconds * rate;
  std::vector<double> arguments{0, h, static_cast<double>(frames)};
  for (int n = 0; n < frames; ++n)
    arguments.insert(arguments.end(), {1.0 / rate, is_slow((n + 0.5) / rate) ? 0.25 : 1});
  const std::vector<double> answers = who.call(0, arguments, 3 * static_cast<std::size_t>(frames));
  std::vector<double> times{0};
  double steps = 0;
  for (std::size_t n = 0; n < answers.size(); n += 3) {
    steps += answers[n];
    times.push_back((steps + answers[n + 1]) * h);
  }
  return times;
}

Vec hopped(double time, double lane) {
  constexpr double gravity = 9.81, up = 3.1, hop = 2 * up / gravity;
  const double since = time - hop * std::floor(time / hop);
  return {1.5 * time, lane + up * since - gravity / 2 * since * since, 0};
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  struct Screen {
    int rate;  // frames a second
    double lane;
    std::vector<double> yours, right;
  };
  std::vector<Screen> screens;
  for (const int rate : {20, 60, 144})
    screens.push_back({rate, 3 - 1.5 * static_cast<double>(screens.size()), drawn(yours, rate),
                       drawn(right, rate)});
  for (int picture = 0; picture <= pictures; ++picture) {
    stage.picture(1.0 / 60);
    for (const Screen& screen : screens) {
      const std::string name = std::to_string(screen.rate) + " Hz";
      const auto frame = static_cast<std::size_t>(picture * screen.rate / 60);
      stage.line({-0.3, screen.lane - 0.1, 0}, {6, screen.lane - 0.1, 0}, "scenery");
      stage.label({5.7, screen.lane + 0.15, 0}, name);
      stage.balls(name, hopped(screen.yours[frame], screen.lane),
                  hopped(screen.right[frame], screen.lane), 0.1);
    }
    if (is_slow(picture / 60.0)) stage.label({3, 4.1, 0}, "slow motion");
  }
}

const grade::Staged staged({
    .exercise = "1-test-case/leftover-time",
    .caption =
        "One ball hops along on three screens, and from 1.5 s to 3.5 s in slow motion. The ring "
        "goes by the right clock, and the ball in it by yours. A ball that runs ahead, falls "
        "behind or jumps has been given steps that were not due, or too few, or a blend that "
        "does not fit them.",
    .view = {{-0.5, -0.4}, {6.2, 4.4}},
    .film = film,
});

}  // namespace
