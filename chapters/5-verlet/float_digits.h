// SPDX-License-Identifier: MIT-0
/// @file
/// What single precision costs a method.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "measure/run.h"
#include "scenes/spring.h"

/// How far two runs of a swing, in single and in double precision, part in ten seconds [m].
template <class Step>
double lost_digits(Step step) {
  const scenes::Spring<float> coarse{.omega = 6.28f, .x0 = 1};
  const scenes::Spring<> fine{.omega = coarse.omega, .x0 = 1};
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
