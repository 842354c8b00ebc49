// SPDX-License-Identifier: MIT-0
/// @file
/// The drone of chapter 3 in single precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "measure/many_starts.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/circle.h"
#include "toys.h"
#include "wrong.h"

/// The largest error of one turn of a drone whose place, velocity and step are floats [m].
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param rate  steps per second; a power of two, so that the step is no rounded number
/// @param angle  of the place on the circle where it starts [rad]
template <class Step>
double error_in_float(Step step, int rate, double angle = 0) {
  const scenes::Circle<float> single{.omega = float(drone.omega), .radius = 10};
  const scenes::Circle<> truth{.omega = double(single.omega), .radius = 10};
  const double since = angle / truth.omega;
  const auto start = truth.exact(since);
  scenes::State<scenes::Circle<float>::Vec> s{start.x.cast<float>(), start.v.cast<float>()};
  double largest = 0;
  long n = 0;
  measure::run(step, single, s, 1.0f / float(rate), 8L * rate, [&](float, const auto& now) {
    const auto right = truth.exact(since + double(n++) / rate).x;
    largest = std::max(largest, (now.x.template cast<double>() - right).norm());
  });
  return largest;
}

inline constexpr int starts = 1000;  ///< places around the circle

/// The errors from each of them, in order of size [m].
template <class Step>
std::vector<double> errors_in_float(Step step, int rate) {
  return measure::all_around(starts,
                             [&](double angle) { return error_in_float(step, rate, angle); });
}

/// The orders that a float shows when 16 steps a second become 32.
template <class Step>
std::vector<double> orders_in_float(Step step) {
  return measure::all_around(starts, [&](double angle) {
    return std::log2(error_in_float(step, 16, angle) / error_in_float(step, 32, angle));
  });
}

/// What single precision makes of RK4, and of RK4 with its fourth stage along the second slope.
inline void single_precision(measure::Record& record) {
  record.number("single-starts", starts, measure::whole);
  for (const int rate : {16, 32, 128}) {
    record.number("single-" + std::to_string(rate),
                  1e6 * measure::median(errors_in_float(measure::rk4, rate)), 1, "µm");
  }
  record.number("single-order", measure::median(orders_in_float(measure::rk4)), 1);
  const auto bug = wrong::method_of(wrong::fourth_looks_too_soon.stages);
  record.number("single-bug", measure::median(orders_in_float(bug)), 1);
}
