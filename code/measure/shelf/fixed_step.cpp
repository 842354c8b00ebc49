// SPDX-License-Identifier: MIT-0
#include "shelf/fixed_step.h"

#include <cmath>
#include <limits>
#include <vector>

#include "frames/recorded.h"
#include "measure/shelf/every_card.h"

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

// The heights after each step, from frames that a clock brings for ten seconds.
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

long steps_of(double length) {
  shelf::FixedStep<> clock{.h = 1.0 / 64};
  clock.frame(length, [](double) {});
  return clock.steps;
}

Promise cut() {
  const long longest = steps_of(0.25), hour = steps_of(3600),
             ever = steps_of(std::numeric_limits<double>::infinity());
  return {"a frame longer than the longest takes as many steps as the longest",
          longest == 16 && hour == longest && ever == longest, double(hour), whole, "steps"};
}

Promise not_a_frame() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  shelf::FixedStep<> clock{.h = 1.0 / 64, .saved = 1.0 / 128};
  for (const double length : {-3600.0, nan, -nan}) clock.frame(length, [](double) {});
  const long taken = clock.steps;
  clock.frame(1.0 / 128, [](double) {});
  return {"a frame whose length is negative or not a number takes no step and stops no clock",
          taken == 0 && clock.steps == 1, double(taken), whole, "steps"};
}

}  // namespace

ShelfCard fixed_step() {
  return {"fixed_step", {same_steps(), time_kept(), cut(), not_a_frame()}};
}

}  // namespace measure::shelf_cards
