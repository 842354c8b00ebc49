// SPDX-License-Identifier: MIT-0
// A camera that follows a drone on three machines.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double part = 0.1, fastest = 15;  // [m/s]
constexpr int seconds = 6;                  // of sixty ticks each

struct Machine {
  const char* name;
  double lane;
  int frame, hitch;  // [ticks]; the hitch comes after 1.4 s

  int frame_at(int tick) const { return tick == 84 ? hitch : frame; }
};

constexpr Machine machines[] = {
    {"60 Hz", 10, 1, 1}, {"4 Hz", 5, 15, 15}, {"60 Hz, with a hitch", 0, 1, 45}};

/// The drone stands still, and is elsewhere after three seconds.
double drone(int tick) {
  return tick < 180 ? 27 : 2;
}

/// Where the camera is at each tick.
std::vector<Vec> followed(judge::Student& who, const Machine& machine) {
  std::vector<Vec> places;
  Vec camera{2, 0, 0};
  for (int tick = 0; tick < 60 * seconds; tick += machine.frame_at(tick)) {
    const int frame = machine.frame_at(tick);
    places.insert(places.end(), static_cast<std::size_t>(frame), camera);
    const std::vector<double> next = who.call(
        0, judge::as_numbers(camera, Vec{drone(tick), 0, 0}, part, fastest, frame / 60.0), 3);
    camera = {next[0], next[1], next[2]};
  }
  return places;
}

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  std::vector<std::vector<Vec>> mine, best;
  for (const Machine& machine : machines) {
    mine.push_back(followed(yours, machine));
    best.push_back(followed(right, machine));
  }
  for (std::size_t tick = 0; tick < 60 * seconds; tick += 2) {
    stage.picture(2.0 / 60);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Machine& machine = machines[n];
      const Vec lane{0, machine.lane, 0};
      stage.ball("drone", lane + Vec{drone(static_cast<int>(tick)), 0, 0}, 0.5, "scenery");
      stage.trails(machine.name, lane + mine[n][tick], lane + best[n][tick]);
      stage.boxes(machine.name, lane + mine[n][tick], lane + best[n][tick], {4.8, 3, 0});
      stage.label(lane + Vec{14.5, -2.1, 0}, machine.name);
    }
  }
}

const grade::Staged staged({
    .exercise = "2-euler/camera-that-lags",
    .caption =
        "A camera, drawn as the frame of what it sees, follows a drone that is suddenly 25 m "
        "away, first to the right and then to the left. It may go 15 m/s. On all three machines "
        "it should be in the same place whenever their frames end together. Where you see a "
        "second frame beside yours, yours was too slow or too fast, and where your line runs on "
        "behind the drone, too far.",
    .view = {{-3, -3}, {36, 12}},
    .film = film,
});

}  // namespace
