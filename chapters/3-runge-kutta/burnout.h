// SPDX-License-Identifier: MIT-0
/// @file
/// An engine that stops in the middle of a step, in chapter 3.
#pragma once
#include <array>
#include <cmath>

#include "integrate/rk4.h"
#include "measure/error.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "toys.h"

/// How far a method that steps across the burnout is off at most, until `rocket_time` [m].
template <class Step>
double error_across(Step step, double rate) {
  const long all = std::lround(rocket_time * rate);
  return measure::largest_error(step, off_beat_rocket, 1 / rate, all).position;
}

/// The same for RK4, and how far it is off in the end with one step cut at the burnout [m].
inline std::array<double, 2> burnout_errors(double rate) {
  const double step = 1 / rate, stop = off_beat_rocket.burn_time;
  // [cut]
  const auto engine_off = [](double, double, double) { return -off_beat_rocket.g; };
  const auto steps = long(std::floor(stop * rate));
  auto s = measure::after(measure::rk4, engine_on, engine_on.start(), step, steps);
  const double done = double(steps) * step;
  integrate::rk4(s.x, s.v, done, stop - done, engine_on);
  integrate::rk4(s.x, s.v, stop, rocket_time - stop, engine_off);
  // [cut]
  return {error_across(measure::rk4, rate), std::abs(s.x - off_beat_rocket.exact(rocket_time).x)};
}

inline constexpr int slowest = 20, fastest = 240;  ///< rates at which RK4 meets Euler's method

/// How far off the rocket is against the number of steps, with and without the cut.
inline void burnout(measure::Record& record) {
  auto& table = record.table(
      "burnout", {{"steps per second", "", measure::whole}, {"across", "m"}, {"cut", "m"}});
  for (double rate = 4; rate <= 1024; rate = std::ceil(rate * 1.12)) {
    const auto [across, cut] = burnout_errors(rate);
    table.add({rate, across, cut});
  }
  const auto [across, cut] = burnout_errors(60);
  record.number("burnout-across", 100 * across, 3, "cm");
  record.number("burnout-euler", 100 * error_across(measure::euler, 60), 3, "cm");
  int worse = 0;
  for (int rate = slowest; rate <= fastest; ++rate)
    worse += error_across(measure::rk4, rate) > error_across(measure::euler, 4 * rate);
  record.number("burnout-worse", 100.0 * worse / (fastest - slowest + 1), 2, "%");
  record.number("burnout-cut", 1e9 * cut, 2, "nm");
}
