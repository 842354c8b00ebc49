// SPDX-License-Identifier: MIT-0
/// @file
/// The drone of chapter 3 in single precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/circle.h"
#include "toys.h"
#include "wrong.h"

/// The largest error of one turn of a drone whose place, velocity and step are floats [m].
/// @param step  a method, called as `step(x, v, t, h, scene)`
/// @param rate  steps per second; a power of two, so that the step is no rounded number
template <class Step>
double error_in_float(Step step, int rate) {
  const scenes::Circle<float> single{.omega = float(drone.omega), .radius = 10};
  const scenes::Circle<> truth{.omega = double(single.omega), .radius = 10};
  auto s = single.start();
  double largest = 0;
  long n = 0;
  measure::run(step, single, s, 1.0f / float(rate), 8L * rate, [&](float, const auto& now) {
    const auto right = truth.exact(double(n++) / rate).x;
    largest = std::max(largest, (now.x.template cast<double>() - right).norm());
  });
  return largest;
}

/// The order that a float shows when 16 steps a second become 32, the last halving of the table.
template <class Step>
double order_in_float(Step step) {
  return std::log2(error_in_float(step, 16) / error_in_float(step, 32));
}

/// What single precision makes of RK4, and of RK4 with its fourth stage along the second slope.
inline void single_precision(measure::Record& record) {
  for (const int rate : {16, 32, 128}) {
    record.number("single-" + std::to_string(rate), 1e6 * error_in_float(measure::rk4, rate), 2,
                  "µm");
  }
  const auto bug = wrong::method_of(wrong::fourth_looks_too_soon.stages);
  record.number("single-order", order_in_float(measure::rk4), 2);
  record.number("single-order-bug", order_in_float(bug), 2);
}
