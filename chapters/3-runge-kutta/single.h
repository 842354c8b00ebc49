// SPDX-License-Identifier: MIT-0
/// @file
/// The drone of chapter 3 in single precision.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

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

inline constexpr int starts = 200;  ///< places around the circle

/// What `measure(angle)` is from each of them, in order of size.
template <class Measure>
std::vector<double> from_all_places(Measure measure) {
  std::vector<double> found;
  for (int place = 0; place < starts; ++place) {
    found.push_back(measure(2 * std::numbers::pi * place / starts));
  }
  std::sort(found.begin(), found.end());
  return found;
}

template <class Step>
std::vector<double> errors_in_float(Step step, int rate) {
  return from_all_places([&](double angle) { return error_in_float(step, rate, angle); });
}

/// The orders that a float shows when 16 steps a second become 32.
template <class Step>
std::vector<double> orders_in_float(Step step) {
  return from_all_places([&](double angle) {
    return std::log2(error_in_float(step, 16, angle) / error_in_float(step, 32, angle));
  });
}

/// What single precision makes of RK4, and of RK4 with its fourth stage along the second slope.
inline void single_precision(measure::Record& record) {
  record.number("single-starts", starts, measure::whole);
  for (const int rate : {16, 32, 128}) {
    const auto errors = errors_in_float(measure::rk4, rate);
    const std::string name = "single-" + std::to_string(rate);
    record.number(name + "-least", 1e6 * errors.front(), 2, "µm");
    record.number(name + "-most", 1e6 * errors.back(), 2, "µm");
  }
  const auto right = orders_in_float(measure::rk4);
  record.number("single-order-least", right.front(), 2);
  record.number("single-order-most", right.back(), 2);
  const auto bug = orders_in_float(wrong::method_of(wrong::fourth_looks_too_soon.stages));
  record.number("single-bug-least", bug.front(), 2);
  record.number("single-bug-most", bug.back(), 2);
}
