// SPDX-License-Identifier: MIT-0
// Four whirlwinds that turn by a server's clock, after an hour and after a week.
#include <numbers>

#include "home/scene.h"
#include "judge/numbers.h"

namespace {

constexpr int rate = 60, hour = 3600, day = 24 * hour, seconds = 8;

/// What a clock does for some seconds, after so long a time.
struct Heard {
  double begins, ends;
  std::vector<double> struck;  // [s]
  int strokes = 0;

  Heard(judge::Student& who, int after) {
    const std::vector<double> answer =
        who.call(0, judge::as_numbers(rate, after * rate, seconds), 2 + 2 * seconds);
    begins = answer.front() - after;
    ends = answer.back() - after;
    for (std::size_t second = 0; second < seconds; ++second) {
      const double times = answer[1 + 2 * second], last = answer[2 + 2 * second];
      strokes += static_cast<int>(grade::within(times, 0, rate));
      if (times > 0) struck.push_back(static_cast<double>(second) + last / rate);
    }
  }

  /// Where the whirlwind points: it turns in four seconds.
  Vec arm(double t) const {
    const double angle = std::numbers::pi / 2 * (begins + (ends - begins) * t / seconds);
    return {std::sin(angle), std::cos(angle), 0};
  }

  /// The hammer falls at a stroke, and is up again after a third of a second.
  double hammer(double t) const {
    for (const double stroke : struck)
      if (t >= stroke && t < stroke + 0.33) return 1.45;
    return 1.9;
  }
};

void film(grade::Stage& stage, judge::Student& yours, judge::Student& right) {
  struct Whirlwind {
    const char* name;
    int after;
  };
  constexpr Whirlwind all[] = {
      {"an hour", hour}, {"a day", day}, {"four days", 4 * day}, {"a week", 7 * day}};
  std::vector<Heard> mine, best;
  for (const Whirlwind& one : all) {
    mine.emplace_back(yours, one.after);
    best.emplace_back(right, one.after);
  }
  for (int picture = 0; picture <= 30 * seconds; ++picture) {
    const double t = picture / 30.0;
    stage.picture(1 / 30.0);
    for (std::size_t n = 0; n < mine.size(); ++n) {
      const Vec middle{3.4 * static_cast<double>(n), 0, 0}, up{0, 1, 0};
      stage.ball("eye", middle, 0.12, "scenery");
      for (const double side : {1.0, -1.0})
        stage.lines(middle, middle + side * mine[n].arm(t), middle + side * best[n].arm(t));
      stage.balls(all[n].name, middle + mine[n].arm(t), middle + best[n].arm(t), 0.16);
      stage.line(middle + Vec{-0.5, 1.2, 0}, middle + Vec{0.5, 1.2, 0}, "scenery");
      stage.balls(std::string("hammer ") + all[n].name, middle + mine[n].hammer(t) * up,
                  middle + best[n].hammer(t) * up, 0.14);
      stage.label(middle - 1.6 * up, all[n].name);
      stage.label(middle - 2.2 * up, std::to_string(mine[n].strokes) + " strokes");
    }
  }
}

const grade::Staged staged({
    .exercise = "7-which-to-use/clock-in-a-float",
    .caption =
        "Eight seconds of a level whose server has run for an hour, a day, four days and a week, "
        "at sixty ticks a second. The whirlwinds turn by your clock, and the hammers above them "
        "fall when it strikes, which should be once a second. A second arm beside yours is the "
        "true time.",
    .view = {{-1.7, -2.6}, {11.9, 2.3}},
    .film = film,
});

}  // namespace
