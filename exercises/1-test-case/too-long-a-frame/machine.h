// SPDX-License-Identifier: MIT-0
/// @file
/// A machine whose frames are as long as its work.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/random.h"
#include "judge/rounding.h"

namespace machine {

/// What draws frames and takes steps, and how long that takes it.
struct Machine {
  double draw, cost, h;
  int most;

  // How long the frame behind one of this length is, on average.
  double next(double frame) const { return draw + cost * std::min(frame / h, double(most)); }
  double next_without_limit(double frame) const { return draw + cost * frame / h; }

  // Long after the start.
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

/// How long a frame would settle by a mistake.
inline std::vector<std::string> recognise(double got, const Machine& machine) {
  const auto is = [&](double other) {
    return std::abs(got - other) <= judge::rounding(std::abs(other)).value;
  };
  if (is(machine.next_without_limit(got)))
    return {
        machine.cost < machine.h
            ? "so long would frames be without a limit; but a frame takes at most `most` steps"
            : "no frame is below zero: without a limit such a machine never settles, but a frame "
              "takes at most `most` steps"};
  if (is(machine.next(INFINITY)))
    return {
        "this is the longest that a frame can be, with all the steps that it may take; here "
        "frames settle below that"};
  if (is(machine.next(machine.draw)))
    return {
        "this pays for the steps that the drawing asks for; but steps take time, too, and that "
        "asks for more steps"};
  if (is(machine.draw)) return {"this is the drawing alone"};
  return {};
}

}  // namespace machine
