// SPDX-License-Identifier: MIT-0
/// @file
/// An engine that stops in the middle of a step, in chapter 3.
#pragma once
#include <array>
#include <cmath>

#include "integrate/rk4.h"
#include "measure/record.h"
#include "measure/run.h"
#include "toys.h"

/// How far a step is from the height after `rocket_time`, and the same with one step cut at
/// burnout.
inline std::array<double, 2> burnout_errors(double rate) {
  const double truth = rocket.exact(rocket_time).x;
  const long all = std::lround(rocket_time * rate);
  const auto across = measure::after(measure::rk4, rocket, rocket.start(), 1 / rate, all);
  const double step = 1 / rate, stop = rocket.burn_time;
  // [cut]
  const scenes::Rocket<> engine_on{.burn_time = INFINITY};
  const auto engine_off = [](double, double, double) { return -rocket.g; };
  const auto steps = long(std::floor(stop * rate));
  auto s = measure::after(measure::rk4, engine_on, engine_on.start(), step, steps);
  const double done = double(steps) * step;
  integrate::rk4(s.x, s.v, done, stop - done, engine_on);
  integrate::rk4(s.x, s.v, stop, rocket_time - stop, engine_off);
  // [cut]
  return {std::abs(across.x - truth), std::abs(s.x - truth)};
}

/// Height of the rocket against the number of steps, with and without the cut.
inline void burnout(measure::Record& record) {
  auto& table = record.table(
      "burnout", {{"steps per second", "", measure::whole}, {"across", "m"}, {"cut", "m"}});
  for (double rate = 4; rate <= 1024; rate = std::ceil(rate * 1.12)) {
    const auto [across, cut] = burnout_errors(rate);
    table.add({rate, across, cut});
  }
  const auto [across, cut] = burnout_errors(60);
  record.number("burnout-across", 100 * across, 2, "cm");
  record.number("burnout-cut", 1e9 * cut, 2, "nm");
}
