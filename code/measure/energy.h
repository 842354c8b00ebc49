// SPDX-License-Identifier: MIT-0
/// @file
/// The effect of a method on a quantity that the scene conserves.
#pragma once
#include <cmath>

#include "measure/run.h"

namespace measure {

/// What became of a conserved quantity in one run.
struct Drift {
  double largest = 0;        ///< largest relative departure from its first value
  double last = 0;           ///< relative departure at the end, with its sign
  double smallest_gain = 0;  ///< least relative change in any one step, with its sign
};

/// Follows a conserved quantity, such as the energy or the angular momentum, through a run.
///
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param scene  the acceleration; has `start()`
/// @param h  step size [s]
/// @param steps  how many steps
/// @param invariant  called as `invariant(x, v)`; must not be zero at the start
template <class Step, class Scene, class Real, class Invariant>
Drift drift(Step step, const Scene& scene, Real h, long steps, Invariant invariant) {
  auto s = scene.start();
  const double first = invariant(s.x, s.v);
  double before = first;
  Drift found{.smallest_gain = INFINITY};
  run(step, scene, s, h, steps, [&](Real t, const auto& now) {
    const double value = invariant(now.x, now.v);
    found.last = (value - first) / std::abs(first);
    if (!(std::abs(found.last) <= found.largest)) found.largest = std::abs(found.last);
    const double gain = (value - before) / std::abs(before);
    if (t > 0 && !(gain >= found.smallest_gain)) found.smallest_gain = gain;
    before = value;
  });
  return found;
}

}  // namespace measure
