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

/// How high the jump goes when every frame is one step [m].
template <class Step>
double apex(Step step, int frames_per_second) {
  double highest = 0;
  auto s = jump.start();
  measure::run(step, jump, s, 1.0 / frames_per_second, frames_per_second,
               [&](double, const auto& now) { highest = std::max(highest, now.x.y()); });
  return highest;
}
