// SPDX-License-Identifier: MIT-0
/// @file
/// A machine whose frames are as long as its work.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "format_values.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/rounding.h"

namespace machine {

/// A machine that draws frames and takes steps, and the time that it takes for them.
struct Machine {
  double draw, cost, h;
  int most;

  // The length of the frame behind one of this length, on average.
  double next(double frame) const { return draw + cost * std::min(frame / h, double(most)); }

  // The length of a frame long after the start.
  double settled() const {
    double frame = draw;
    for (int n = 0; n < 2000; ++n) frame = next(frame);
    return frame;
  }
};

inline std::string describe(const Machine& machine) {
  return "draw = " + grade::number(machine.draw, 17) +
         " s, cost = " + grade::number(machine.cost, 17) +
         " s, h = " + grade::number(machine.h, 17) + " s, most = " + std::to_string(machine.most);
}

/// A machine of which a step costs so many times what it covers.
inline Machine draw_machine(judge::Random& random, double cost) {
  const double h = 1 / random.between(50, 200);
  return {random.between(0.3, 1.2) * h, cost * h, h, random.whole(5, 9)};
}

/// A machine that keeps up: frames settle at least two steps under the limit.
inline Machine draw_fast(judge::Random& random) {
  Machine machine = draw_machine(random, random.between(0.2, 0.7));
  machine.most = static_cast<int>(std::ceil(machine.settled() / machine.h)) + random.whole(4, 7);
  return machine;
}

/// A machine of any speed, with this step; now and then one whose steps cost about what they cover.
/// None that keeps up needs more than some ten thousand frames to settle.
inline Machine any_machine(judge::Random& random, double h) {
  Machine machine{random.anywhere(harness_bounds::draw), random.anywhere(harness_bounds::cost), h,
                  static_cast<int>(random.anywhere(harness_bounds::most))};
  constexpr double nearest = 1e-3;
  if (random.whole(0, 3) == 0) machine.cost = h * random.nearly_one(nearest, 0.5);
  if (std::abs(machine.cost / h - 1) < nearest) machine.cost = h;
  // The drawing that lets frames settle about at the limit, if it can be so little.
  const double alone = (h - machine.cost) * machine.most * random.between(0.1, 1.1);
  if (alone > harness_bounds::draw.smallest() && random.whole(0, 1) == 0)
    machine.draw = std::min(alone, harness_bounds::draw.largest());
  return machine;
}

}  // namespace machine
