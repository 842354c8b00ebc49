// SPDX-License-Identifier: MIT-0
/// @file
/// The drone of chapter 3 under four methods that ask for the acceleration equally often.
#pragma once
#include <cmath>
#include <string>

#include "measure/evaluations.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "toys.h"

inline constexpr double price = 16;          ///< evaluations a second
inline constexpr double time_for_them = 24;  ///< three turns of the drone [s]

/// Where a method takes the drone for that price, on the circle and on the ellipse.
template <class Step>
void equal_cost(measure::Record& record, const std::string& name, Step step) {
  auto& table = record.table(
      name, {{"circle x", "m"}, {"circle y", "m"}, {"ellipse x", "m"}, {"ellipse y", "m"}});
  const double step_size = double(measure::evaluations_per_step(step, drone, frame)) / price;
  auto round = drone.start(), long_one = ellipse.start();
  const auto steps = std::lround(time_for_them / step_size);
  for (long n = 0; n <= steps; ++n) {
    table.add({round.x.x(), round.x.y(), long_one.x.x(), long_one.x.y()});
    round = measure::after(step, drone, round, step_size, 1);
    long_one = measure::after(step, ellipse, long_one, step_size, 1);
  }
}

/// The same of four methods.
inline void equal_cost(measure::Record& record) {
  equal_cost(record, "equal-euler", measure::euler);
  equal_cost(record, "equal-symplectic", measure::symplectic_euler);
  equal_cost(record, "equal-midpoint", measure::midpoint);
  equal_cost(record, "equal-rk4", measure::rk4);
}
