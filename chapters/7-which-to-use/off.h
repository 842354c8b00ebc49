// SPDX-License-Identifier: MIT-0
/// @file
/// How far a method takes a thing of the level from where it should be.
#pragma once
#include <cmath>

#include "level.h"
#include "measure/error.h"
#include "measure/method.h"

/// The largest distance from where a thing should be [m]; infinite from a kilometre on.
template <class Scene>
double off(const measure::Method& method, const Scene& scene, double h, double seconds) {
  const double error = measure::largest_error(method, scene, h, std::lround(seconds / h)).position;
  return error < 1000 ? error : INFINITY;
}
