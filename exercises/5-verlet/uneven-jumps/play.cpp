// SPDX-License-Identifier: MIT-0
// A jump with even frames, and with a busy disk.
#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr double tick = 1.0 / 60, gravity = 9.81;  // [s], [m/s^2]
constexpr Vec start{0, 0, 0}, leap{4, 6, 0};       // [m], [m/s]

Vec jumped(double t) {
  return start + t * leap + t * t / 2 * Vec{0, -gravity, 0};
}

/// A jump in frames of so many ticks each.
struct Jump {
  const char* name;
  double lane;
  std::vector<int> frames;

  std::vector<Vec> places(judge::Student& who) const {
    const harness::Force falling{harness::Force::falling, {gravity}};
    const double before = frames.front() * tick;
    std::vector<double> asked = judge::as_numbers(falling, start, jumped(-before), 0, before,
                                                  static_cast<double>(frames.size()));
    for (const int frame : frames) asked.push_back(frame * tick);
    std::vector<Vec> places = judge::as_vectors(who.call(0, asked, 3 * frames.size()));
    places.insert(places.begin(), start);
    return places;
  }

  /// At the end of each frame but the last, told from true places.
  std::vector<Vec> velocities(judge::Student& who) const {
    std::vector<Vec> velocities{leap};
    double t = 0;
    for (std::size_t n = 1; n < frames.size(); ++n) {
      const double last = frames[n - 1] * tick, next = frames[n] * tick;
      t += last;
      const std::vector<double> asked =
          judge::as_numbers(jumped(t - last), jumped(t), jumped(t + next), last, next);
      velocities.push_back(judge::as_vectors(who.call(1, asked, 3)).at(0));
    }
    return velocities;
  }

  /// The frame that has ended last.
  std::size_t ended(int ticks) const {
    std::size_t frame = 0;
    for (int end = 0; frame < frames.size() && end + frames[frame] <= ticks; ++frame)
      end += frames[frame];
    return frame;
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  const Jump jumps[] = {
      {"even frames", 2.9, std::vector<int>(36, 2)},
      {"a busy disk", 0, {1, 1, 8, 1, 1, 1, 12, 1, 1, 10, 1, 1, 1, 12, 1, 1, 1, 8, 1, 1, 8}}};
  std::vector<std::vector<Vec>> mine, best, fast, true_fast;
  for (const Jump& jump : jumps) {
    mine.push_back(jump.places(yours));
    best.push_back(jump.places(right));
    fast.push_back(jump.velocities(yours));
    true_fast.push_back(jump.velocities(right));
  }
  for (int ticks = 0; ticks <= 72; ++ticks) {
    stage.picture(tick);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Jump& jump = jumps[n];
      const Vec lane{0, jump.lane, 0}, top{0, jump.lane + leap.y * leap.y / (2 * gravity), 0};
      const std::size_t frame = jump.ended(ticks), known = std::min(frame, fast[n].size() - 1);
      const Vec hero = lane + mine[n][frame], ring = lane + best[n][frame];
      stage.line(lane - Vec{0.3, 0, 0}, lane + Vec{5.3, 0, 0}, "scenery");
      stage.line(top - Vec{0.3, 0, 0}, top + Vec{5.3, 0, 0}, "scenery");
      stage.trails(jump.name, hero, ring);
      stage.lines(ring, ring + 0.15 * fast[n][known], ring + 0.15 * true_fast[n][known]);
      stage.balls(jump.name, hero, ring, 0.11);
      stage.label(lane + Vec{2.4, 0.4, 0}, jump.name);
    }
  }
}

const grade::Staged staged({
    .exercise = "5-verlet/uneven-jumps",
    .caption =
        "One jump with even frames, and one with frames of a sixtieth of a second to a fifth, "
        "both four times slower. They should rise to the upper grey line. The dart on the ring "
        "is your velocity, told from true places: where a second dart shows beside it, yours is "
        "the velocity of another moment.",
    .view = {{-0.5, -0.9}, {5.5, 5}, 0.25},
    .film = film,
});

}  // namespace
