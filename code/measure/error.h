// SPDX-License-Identifier: MIT-0
/// @file
/// How far a run strays from the exact solution of its scene.
#pragma once
#include <cmath>

#include "measure/length.h"
#include "measure/run.h"

namespace measure {

/// The two errors of a run.
struct Error {
  double position = 0;  ///< [units of x]
  double velocity = 0;  ///< [units of x per s]
};

// [largest]
/// The largest distance from the exact solution that a run shows at any of its steps.
///
/// The largest and not the last: at one instant an error can pass through zero by luck. A run that
/// ends as not a number has that as its error; `std::max` would pass over it.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  has `start()` and `exact(t)`
/// @param h  step size [s]
/// @param steps  how many steps
template <class Step, class Scene, class Real>
Error largest_error(Step step, const Scene& scene, Real h, long steps) {
  Error largest;
  auto s = scene.start();
  run(step, scene, s, h, steps, [&](Real t, const auto& now) {
    const auto truth = scene.exact(t);
    const auto position = length(now.x - truth.x);
    const auto velocity = length(now.v - truth.v);
    // Not >: what is not a number is to count as the largest.
    if (!(position <= largest.position)) largest.position = position;
    if (!(velocity <= largest.velocity)) largest.velocity = velocity;
  });
  return largest;
}
// [largest]

}  // namespace measure
