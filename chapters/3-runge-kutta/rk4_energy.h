// SPDX-License-Identifier: MIT-0
/// @file
/// What RK4 does to energy, in chapter 3.
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "measure/energy.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "measure/stability.h"
#include "toys.h"

/// What is left of an undamped spring's energy after `steps` steps of RK4.
inline double left_after(long steps, double homega) {
  return std::pow(measure::spectral_radius(measure::rk4, scenes::Spring<>{}, homega),
                  2.0 * double(steps));
}

inline constexpr double wide_turn = 1.5;  ///< h omega of the step that is drawn term by term

/// A step of RK4 on a spring, taken apart: the arrow at the start, with one term added after the
/// other, and where the arrow should be.
inline void arrow(measure::Record& record) {
  auto& table = record.table("arrow", {{"stretch"}, {"velocity"}});
  double stretch = 1, velocity = 0, across = 1, up = 0;
  table.add({stretch, velocity});
  for (int term = 1; term <= 4; ++term) {
    // A quarter turn clockwise, and shorter or longer by h omega over the number of the term.
    const double before = across;
    across = wide_turn / term * up;
    up = -wide_turn / term * before;
    stretch += across;
    velocity += up;
    table.add({stretch, velocity});
  }
  table.add({std::cos(wide_turn), -std::sin(wide_turn)});
  const scenes::Spring<> unit;
  const auto end = measure::after(measure::rk4, unit, unit.start(), wide_turn, 1);
  record.number("arrow-length", std::hypot(end.x, end.v), 3);
  record.number("arrow-turn", std::atan2(-end.v, end.x) * 180 / std::numbers::pi, 3, "°");
  record.number("arrow-right", wide_turn * 180 / std::numbers::pi, 3, "°");
  record.number("arrow-angle", wide_turn, 2);
}

/// What becomes of the energy: in a step, in a minute, in a day and in a swing.
inline void energy(measure::Record& record) {
  arrow(record);
  auto& factors = record.table("factors", {{"hω"}, {"Euler"}, {"midpoint"}, {"RK4"}});
  const auto factor = [](auto step, double homega) {
    return std::pow(measure::spectral_radius(step, scenes::Spring<>{}, homega), 2);
  };
  for (double homega = 0.15; homega < 3.1; homega += 0.15) {
    factors.add({homega, factor(measure::euler, homega), factor(measure::midpoint, homega),
                 factor(measure::rk4, homega)});
  }

  auto& minute =
      record.table("minute", {{"t", "s"}, {"2 Hz"}, {"3 Hz"}, {"4 Hz"}, {"6 Hz"}, {"8 Hz"}});
  for (int halves = 0; halves <= 120; ++halves) {
    std::vector<measure::Cell> row{halves / 2.0};
    for (const int swings : {2, 3, 4, 6, 8}) {
      const auto spring = swinging(swings);
      const auto spring_energy = [&](double x, double v) { return spring.energy(x, v); };
      row.push_back(1 +
                    measure::drift(measure::rk4, spring, frame, 30 * halves, spring_energy).last);
    }
    minute.add(row);
  }
  for (const std::size_t column : {1u, 3u}) {
    const std::string swings = minute.columns[column].name.substr(0, 1);
    record.number("lost-at-" + swings, 100 * (1 - minute.rows.back()[column].value), 2, "%");
  }

  const auto drone_energy = [](auto& x, auto& v) { return drone.energy(x, v); };
  const double day =
      -measure::drift(measure::rk4, drone, frame, 24L * 3600 * 60, drone_energy).last;
  record.number("drone-day", 100 * day, 2, "%");
  record.number("drone-years", 0.01 / day / 365.25, 2, "years");

  const double forty = 2 * std::numbers::pi / 40;  // steps of each of four swings a second
  record.number("forty-minute", 100 * (1 - left_after(4 * 40 * 60L, forty)), 2, "%");
  record.number("forty-hour", 100 * (1 - left_after(4 * 40 * 3600L, forty)), 2, "%");

  double line = 1, over = 10;  // swings per second
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (line + over) / 2;
    (left_after(3600, frame * swinging(middle).omega) > 0.99 ? line : over) = middle;
  }
  record.number("line", line, 2, "Hz");
  record.number("line-steps", 60 / line, 2);

  auto& swing = record.table("swing", {{"steps per swing", "", measure::whole},
                                       {"hω", "", 3},
                                       {"energy lost in one swing", "%", 2},
                                       {"swings until half is gone", "", 2}});
  for (const long steps : {80, 40, 20, 10, 5}) {
    const double homega = 2 * std::numbers::pi / double(steps);
    const double left = left_after(steps, homega);
    swing.add({double(steps), homega, 100 * (1 - left), std::log(0.5) / std::log(left)});
  }

  const auto ellipse_energy = [](auto& x, auto& v) { return ellipse.energy(x, v); };
  const double change =
      measure::drift(measure::rk4, ellipse, 8.0 / 60, 30 * 60, ellipse_energy).last;
  record.number("ellipse-60", 100 * std::abs(change), 2, "%");
}
