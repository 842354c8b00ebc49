// SPDX-License-Identifier: MIT-0
/// @file
/// A drone that flies once around its tower in steps of Euler's method.
#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "format_values.h"
#include "judge/method.h"
#include "judge/random.h"

namespace drone {

constexpr int most_steps = 200000;  ///< that the judge will fly

/// The path of the drone over so many steps.
/// @param every  how many steps lie between two places that are kept
/// @param angle  that all of them cover on the circle of one metre
inline judge::Path fly(int steps, int every = 1, double angle = 2 * std::numbers::pi) {
  const harness::Force leash{harness::Force::spring, {1, 0}};
  return judge::run(judge::euler, {{1, 0, 0}, {0, 1, 0}, 0}, angle / steps, steps, every, leash);
}

/// The share by which the distance has grown then; without end if there is no step.
inline double growth(int steps, double angle = 2 * std::numbers::pi) {
  if (steps < 1 || steps > most_steps) return steps < 1 ? INFINITY : 0;
  return length(fly(steps, steps, angle).states.back().x) - 1;
}

/// The growth that the designer allows, and the fewest steps that stay within it.
struct Turn {
  double growth;
  int fewest;

  /// The turn of a share that is given.
  static Turn of(double growth) {
    int beyond = 0, within = most_steps;
    while (within - beyond > 1) {
      const int steps = (beyond + within) / 2;
      (drone::growth(steps) > growth ? beyond : within) = steps;
    }
    return {growth, within};
  }

  /// A turn that allows what lies so far from the fewest steps' growth to one fewer's; a hundredth
  /// of the way from either is more than rounding can choose.
  static Turn between(int steps, double share) {
    const double within = drone::growth(steps), beyond = drone::growth(steps - 1);
    return {within + share * (beyond - within), steps};
  }

  static Turn draw(judge::Random& random, double low, double high) {
    const double steps = std::exp(random.between(std::log(low), std::log(high)));
    return between(static_cast<int>(steps), random.between(0.2, 0.8));
  }
};

/// Diagnoses of a wrong number of steps.
inline std::vector<std::string> what_is_wrong(const Turn& turn, int steps) {
  if (steps < 1) return {"this is no number of steps: " + std::to_string(steps)};
  if (steps == turn.fewest - 1) return {"one step too few: did you round down?"};
  if (steps == turn.fewest + 1) return {"one step too many: it can be spared"};
  return {};
}

}  // namespace drone
