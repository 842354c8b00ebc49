// SPDX-License-Identifier: MIT-0
/// @file
/// The order of a method, measured: what halving the step does to the error.
#pragma once
#include <cmath>
#include <vector>

#include "measure/error.h"

namespace measure {

/// One row of an order study: a step, its errors, and the order that they show.
///
/// The order is log2 of the error of the row before over the error of this row. The first row has
/// none: it is not a number there.
struct Halving {
  double h = 0;                 ///< step size [s]
  Error error;                  ///< largest errors of the run with this step
  double position_order = NAN;  ///< order in position
  double velocity_order = NAN;  ///< order in velocity
};

// [halvings]
/// Runs the scene for `duration` with the step `h`, then `h/2`, `h/4`, and so on.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  has `start()` and `exact(t)`
/// @param h  the first and largest step [s]; divides `duration`
/// @param duration  length of each run [s]
/// @param rows  how many step sizes
/// @returns one row for each step size, the largest step first
template <class Step, class Scene>
std::vector<Halving> halvings(Step step, const Scene& scene, double h, double duration, int rows) {
  std::vector<Halving> study;
  for (int row = 0; row < rows; ++row, h /= 2) {
    const long steps = std::lround(duration / h);
    Halving now{.h = h, .error = largest_error(step, scene, h, steps)};
    if (row > 0) {
      const Error before = study.back().error;
      now.position_order = std::log2(before.position / now.error.position);
      now.velocity_order = std::log2(before.velocity / now.error.velocity);
    }
    study.push_back(now);
  }
  return study;
}
// [halvings]

}  // namespace measure
