// SPDX-License-Identifier: MIT-0
/// @file
/// The jump of chapter 1.
#pragma once
#include <algorithm>

#include "../cast.h"
#include "measure/run.h"

inline constexpr double ledge = 1.33;  ///< how high it is [m]

/// How high the jump goes without any computer [m].
inline double top_of_jump() {
  const double v = jump.start_velocity.y();
  return v * v / (2 * jump.g);
}

/// How far a jump in steps is above the true one after some time [m].
template <class Step>
double too_high(Step step, int rate, double time) {
  const auto steps = long(rate * time + 0.5);
  const double t = double(steps) / rate;
  return measure::after(step, jump, jump.start(), 1.0 / rate, steps).x.y() - jump.exact(t).x.y();
}

/// How high the jump goes when every frame is one step [m].
template <class Step>
double apex(Step step, int frames_per_second) {
  double highest = 0;
  auto s = jump.start();
  measure::run(step, jump, s, 1.0 / frames_per_second, frames_per_second,
               [&](double, const auto& now) { highest = std::max(highest, now.x.y()); });
  return highest;
}
