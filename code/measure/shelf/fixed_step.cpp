// SPDX-License-Identifier: MIT-0
#include "shelf/fixed_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "frames/recorded.h"
#include "measure/shelf_card.h"

namespace measure::shelf_cards {
namespace {

// A jump, step by step: what a game would show, if it showed each.
struct Jump {
  double height = 0, speed = 5;

  void step(double h) {
    speed = speed - 9.81 * h;
    height = height + speed * h;
  }
};

// The heights after each step, from frames that a clock brings until there are 600.
template <class Frame>
std::vector<double> heights(Frame frame) {
  shelf::FixedStep<> clock;
  Jump jump;
  std::vector<double> all;
  while (clock.steps < 600) {
    clock.frame(frame(), [&](double) {
      jump.step(clock.h);
      all.push_back(jump.height);
    });
  }
  all.resize(600);
  return all;
}

Promise same_steps() {
  frames::Playback recorded;
  const auto even = heights([] { return 1.0 / 60; });
  const auto uneven = heights([&] { return recorded.next(); });
  int different = 0;
  for (std::size_t n = 0; n < even.size(); ++n) different += even[n] != uneven[n];
  return {"the same steps, to the last bit, from even frames and from 600 recorded ones",
          different == 0, different == 0 ? Cell("the same") : Cell(different), whole};
}

Promise time_kept() {
  shelf::FixedStep<> clock{.longest_frame = 1};
  double total = 0;
  for (const double length : frames::recorded) {
    total += length;
    clock.frame(length, [](double) {});
  }
  const double off = std::abs(double(clock.steps) * clock.h + clock.saved - total) / total;
  return {"steps and saved time add up to the time that the frames took, to 1e-12 of it",
          off < 1e-12, off};
}

long long steps_of(double length) {
  shelf::FixedStep<> clock{.h = 1.0 / 64};
  clock.frame(length, [](double) {});
  return clock.steps;
}

Promise cut() {
  const long long longest = steps_of(0.25), hour = steps_of(3600),
                  ever = steps_of(std::numeric_limits<double>::infinity());
  return {"a frame longer than the longest takes as many steps as the longest",
          longest == 16 && hour == longest && ever == longest, double(hour), whole, "steps"};
}

Promise not_a_frame() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  shelf::FixedStep<> clock{.h = 1.0 / 64, .saved = 1.0 / 128};
  for (const double length : {-3600.0, nan, -nan}) clock.frame(length, [](double) {});
  const long long taken = clock.steps;
  clock.frame(1.0 / 128, [](double) {});
  return {"a frame whose length is negative or not a number takes no step and stops no clock",
          taken == 0 && clock.steps == 1, double(taken), whole, "steps"};
}

// How long after the step before a step begins at least and at most, a day after the start [s].
template <class Clock>
std::pair<double, double> apart_after_a_day(Clock clock) {
  clock.steps = 60LL * 60 * 60 * 24;
  double before = 0, least = 1, most = 0;
  while (clock.steps < 60LL * (60 * 60 * 24 + 10)) {
    clock.frame(clock.h, [&](auto t) {
      if (before > 0) {
        least = std::min(least, double(t) - before);
        most = std::max(most, double(t) - before);
      }
      before = double(t);
    });
  }
  return {least, most};
}

// How far two steps in a row are from h apart, a day after the start, as a share of h.
template <class Clock>
double uneven_after_a_day(Clock clock) {
  const double h = double(clock.h);
  const auto [least, most] = apart_after_a_day(clock);
  return std::max(most - h, h - least) / h;
}

Promise day() {
  const double off = std::max(uneven_after_a_day(shelf::FixedStep<>()),
                              uneven_after_a_day(shelf::FixedStep<float>()));
  return {
      "after a day at 60 Hz two steps in a row begin h apart, to 1e-9 of it, where h is a float, "
      "too",
      off < 1e-9, off};
}

Promise day_in_float() {
  const auto [least, most] = apart_after_a_day(shelf::FixedStep<float, float>());
  return {"where the time is a float, they begin 15.6 or 23.4 ms apart",
          least == 1.0 / 64 && most == 3.0 / 128, 1000 * most, 1, "ms"};
}

Promise slow_motion() {
  const bool same = heights([] { return 1.0 / 60; }) == heights([] { return 0.25 / 60; });
  return {"frames a quarter as long, for slow motion, make the same steps, to the last bit", same,
          same ? Cell("the same") : Cell("others")};
}

Promise other_steps() {
  shelf::FixedStep<> clock{.longest_frame = 1};
  double total = 0, off = 0;
  int seconds = 0;
  for (int minute = 0; minute < 60; ++minute) {
    for (const double length : frames::recorded) {
      total += length;
      clock.frame(length, [](double) {});
      off = std::max(off, std::abs(clock.time() + clock.saved - total) / total);
      if (total < seconds + 1) continue;
      ++seconds;
      clock.change_step(1.0 / (30 + 7 * (seconds % 20)));
    }
  }
  return {"with another h once a second, steps and time still add up, to 1e-12 of the time",
          off < 1e-12, off};
}

}  // namespace

ShelfCard fixed_step() {
  return {"fixed_step",
          {same_steps(), time_kept(), cut(), not_a_frame(), day(), day_in_float(), slow_motion(),
           other_steps()}};
}

}  // namespace measure::shelf_cards
