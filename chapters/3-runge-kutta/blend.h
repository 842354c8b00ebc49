// SPDX-License-Identifier: MIT-0
/// @file
/// What is drawn between two long steps, in chapter 3.
#pragma once
#include <algorithm>
#include <cmath>

#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "toys.h"

/// How far a picture is from the truth, halfway between two steps of RK4 [m].
struct Blend {
  double line = 0;   ///< drawn on the straight line between the two
  double curve = 0;  ///< drawn on the cubic that has their places and their velocities
};

/// Steps the suspension for a second and looks halfway between the steps.
/// @param rate  steps per second
inline Blend blend_errors(int rate) {
  const double step = 1.0 / rate;
  Blend largest;
  auto s = suspension.start();
  auto before = s;
  measure::run(measure::rk4, suspension, s, step, rate, [&](double t, const auto& now) {
    const double line = (before.x + now.x) / 2;
    const double curve = line + step / 8 * (before.v - now.v);
    const double truth = suspension.exact(t - step / 2).x;
    if (t > 0) {
      largest.line = std::max(largest.line, std::abs(line - truth));
      largest.curve = std::max(largest.curve, std::abs(curve - truth));
    }
    before = now;
  });
  return largest;
}

/// What a screen would show between two steps of a twentieth of a second.
inline void blends(measure::Record& record) {
  record.number("blend-line", 100 * blend_errors(20).line, 2, "cm");
  record.number("blend-curve", 100 * blend_errors(20).curve, 2, "cm");
}
