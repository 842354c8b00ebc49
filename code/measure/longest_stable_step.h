// SPDX-License-Identifier: MIT-0
/// @file
/// The longest step in which a method holds a linear scene.
#pragma once
#include <cmath>

#include "measure/stability.h"

namespace measure {

/// The longest step up to which a linear scene stays bounded; zero if it never does, infinite if it
/// does up to a step of 1000.
///
/// Steps below 0.05 are not tried: a method that keeps two positions has few digits left there for
/// the difference between them.
///
/// @param method  called as `method(x, v, t, h, scene)`, or one with a memory
/// @param scene  linear in x and v, one-dimensional, with a rate near one
template <class Step, class Scene>
double longest_stable_step(const Step& method, const Scene& scene) {
  const double least = 0.05;
  if (!is_stable(method, scene, least)) return 0;
  for (double h = least; h < 1000; h *= 1.05) {
    if (!is_stable(method, scene, 1.05 * h)) return stability_limit(method, scene, h, 1.05 * h);
  }
  return INFINITY;
}

}  // namespace measure
