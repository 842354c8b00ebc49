// SPDX-License-Identifier: MIT-0
// What depends on the screen: the clock, and the camera.
#include <cmath>

#include "judge/numbers.h"
#include "things.h"

namespace level {
namespace {

constexpr double speed = 5;  // of the runner [m/s]

/// Where the runner is on his way to and fro.
Vec runner(double time) {
  return {20 * std::sin(speed * time / 20), 0, 0};
}

}  // namespace

Hour clock_hour(judge::Student& yours, judge::Student&) {
  Hour hour;
  for (const Screen& screen : screens()) {
    std::vector<double> asked = judge::as_numbers(0, h, screen.frames.size());
    for (const double frame : screen.frames) judge::append(asked, judge::as_numbers(frame, 1));
    const std::vector<double> told = yours.call(0, asked, 3 * screen.frames.size());
    double time = 0, taken = 0;
    for (std::size_t n = 0; n < screen.frames.size(); ++n) {
      time += screen.frames[n];
      taken += told[3 * n];
      // The picture lies between the last two states, and so a step behind.
      hour.hold(speed * std::abs((taken + told[3 * n + 1]) * h - time), screen.name);
    }
  }
  return hour;
}

Hour camera_hour(judge::Student& yours, judge::Student& right) {
  constexpr double part = 0.1, fastest = 12;
  Hour hour;
  for (const Screen& screen : screens()) {
    Vec camera = runner(0), true_camera = camera;
    double time = 0;
    for (const double frame : screen.frames) {
      const auto follow = [&](judge::Student& whose, const Vec& from) {
        const auto asked = judge::as_numbers(from, runner(time), part, fastest, frame);
        return judge::as_vectors(whose.call(0, asked, 3)).front();
      };
      camera = follow(yours, camera);
      true_camera = follow(right, true_camera);
      time += frame;
      hour.hold(length(camera - true_camera), screen.name);
      if (!hour.whole) return hour;
    }
  }
  return hour;
}

}  // namespace level
