// SPDX-License-Identifier: MIT-0
/// @file
/// How many steps a run takes to stay near the truth.
#pragma once
#include "measure/error.h"

namespace measure {

/// Fewest equal steps in which a run never strays further than `error` from the exact solution.
///
/// Found by doubling, then halving the range, so it counts on more steps never being worse.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`, or one with a memory
/// @param scene  has `start()` and `exact(t)`
/// @param duration  of the run [s]
/// @param error  the largest that is allowed, in position [units of x]
template <class Step, class Scene, class Real>
long fewest_steps(Step step, const Scene& scene, Real duration, Real error) {
  const auto good = [&](long steps) {
    return largest_error(step, scene, duration / Real(steps), steps).position <= error;
  };
  long least = 0, enough = 1;
  while (!good(enough)) least = enough, enough *= 2;
  while (enough - least > 1) {
    const long middle = (least + enough) / 2;
    (good(middle) ? enough : least) = middle;
  }
  return enough;
}

}  // namespace measure
