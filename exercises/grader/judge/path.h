// SPDX-License-Identifier: MIT-0
/// @file
/// A path of states, and the positions at which the force was evaluated.
#pragma once
#include <cstddef>
#include <vector>

#include "harness/given.h"

namespace judge {

struct State {
  Vec x;  ///< [m]
  Vec v;  ///< [m/s]
};

struct Start {
  Vec x, v;
  double t = 0;  ///< [s]
};

/// A position at which a method asked for the acceleration.
struct Evaluation {
  Vec x, v;
  double t = 0;
  Vec a{};  ///< what it was told [m/s^2]; known of the judge's own paths
};

/// The states that a method went through, the start first.
struct Path {
  double t = 0;   ///< at the start [s]
  double h = 0;   ///< step size [s]
  int every = 1;  ///< so many steps from one state to the next
  std::vector<State> states;
  std::vector<Evaluation> evaluations;  ///< if the judge evaluated the force

  double time(std::size_t n) const { return t + static_cast<double>(n) * every * h; }
};

/// The larger of two numbers; NaN if one of them is, which std::max may lose.
constexpr double larger(double a, double b) {
  return a > b || a != a ? a : b;
}

/// The larger of the two distances, position and velocity, each in its own unit; NaN if one of them
/// is.
double distance(const State& a, const State& b);

bool is_finite(const State& state);

/// The first state that is not finite; the number of states if all are.
std::size_t first_not_finite(const Path& path);

}  // namespace judge
