// SPDX-License-Identifier: MIT-0
/// @file
/// What single precision costs a method.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "measure/many_starts.h"
#include "measure/run.h"
#include "scenes/spring.h"

/// How far two runs of a swing, in single and in double precision, part in ten seconds [m].
/// @param angle  of its swing at which it starts [rad]
template <class Step>
double lost_digits(Step step, double angle) {
  const float omega = 6.28f;
  const scenes::Spring<float> coarse{
      .omega = omega, .x0 = float(std::cos(angle)), .v0 = float(-double(omega) * std::sin(angle))};
  const scenes::Spring<> fine{.omega = omega, .x0 = coarse.x0, .v0 = coarse.v0};
  constexpr float h = 1 / 240.0f;
  std::vector<double> places;
  auto s = fine.start();
  measure::run(step, fine, s, double(h), 2400,
               [&](double, const auto& now) { places.push_back(now.x); });
  double most = 0;
  auto single = coarse.start();
  std::size_t n = 0;
  measure::run(step, coarse, single, h, 2400, [&](float, const auto& now) {
    most = std::max(most, std::abs(double(now.x) - places[n++]));
  });
  return most;
}

inline constexpr int swings_tried = 1000;  ///< each from another angle

/// How far they part, by the median of many starts [m].
template <class Step>
double lost_digits(Step step) {
  return measure::median(
      measure::all_around(swings_tried, [&](double angle) { return lost_digits(step, angle); }));
}
