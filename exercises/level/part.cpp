// SPDX-License-Identifier: MIT-0
#include "part.h"

#include <cmath>
#include <numbers>

#include "judge/session.h"
#include "things.h"

namespace level {
namespace {

std::vector<double> even(double frame) {
  return std::vector<double>(static_cast<std::size_t>(on_each / frame + 0.5), frame);
}

std::vector<double> uneven() {
  Drawn drawn;
  std::vector<double> frames;
  for (double played = 0; played < on_each; played += frames.back()) {
    const bool hitch = drawn.between(0, 300) < 1;
    frames.push_back(hitch ? drawn.between(0.1, 0.4) : drawn.between(0.007, 0.034));
  }
  return frames;
}

}  // namespace

Drawn::Drawn() : numbers_(judge::session().seed) {}

double Drawn::between(double low, double high) {
  return low + (high - low) * (static_cast<double>(numbers_() >> 11) * 0x1p-53);
}

void Hour::hold(double so_far_off, const std::string& there) {
  whole = whole && std::isfinite(so_far_off);
  if (!(so_far_off > off)) return;
  off = so_far_off;
  where = there;
}

std::vector<Screen> screens() {
  return {{"60 frames a second", even(1.0 / 60)},
          {"30 frames a second", even(1.0 / 30)},
          {"uneven frames", uneven()}};
}

const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"1-test-case/leftover-time", "the clock", "a runner is drawn where he is", 0, clock_hour,
       clock_paths, Look::ball},
      {"2-euler/camera-that-lags", "the camera", "it follows the runner", 0, camera_hour,
       camera_paths, Look::frame},
      {"4-implicit/slow-suspension", "the spring", "a car's hard suspension swings", 0, spring_hour,
       spring_paths, Look::post},
      {"5-verlet/rope-link", "the rope", "a lantern swings on a chain", 0, rope_hour, rope_paths,
       Look::ball},
      {"6-symplectic/rewind-the-replay", "the replay", "a moon circles, and is wound back", 1,
       replay_hour, replay_paths, Look::trail},
      {"7-which-to-use/shuttle-on-a-budget", "the shuttle", "sixty flights",
       1200 / (60 * 2 * std::numbers::pi), shuttle_hour, shuttle_paths, Look::trail},
  };
  return all;
}

bool is_kept(const Part& part, const Hour& hour) {
  return hour.whole && hour.off <= most_off && hour.evaluations <= part.most_evaluations;
}

}  // namespace level
