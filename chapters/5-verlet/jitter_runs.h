// SPDX-License-Identifier: MIT-0
/// @file
/// Ten jumps, a puck and a spring on recorded frames.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "jitter.h"
#include "measure/record.h"
#include "toys.h"

/// How far a spring swings while the recording is played a hundred times [m].
template <class Step>
double widest(Step step, double omega) {
  const scenes::Spring<> spring{.omega = omega, .x0 = 1};
  frames::Playback frames;
  double most = 0;
  uneven_run(
      step, spring, 1080, [&] { return frames.next(); },
      [&](double, double x) { most = std::max(most, std::abs(x)); });
  return most;
}

/// The jump of that number, and the longest frame in it before it lands.
inline void record_late_frame(measure::Record& record, const measure::Table& jumps, double number) {
  const auto value = [&](std::size_t row, std::size_t column) {
    return jumps.rows[row][column].value;
  };
  const auto of_it = [&](std::size_t row) { return value(row, 0) == number && value(row, 2) > 0; };
  std::size_t end = 0;
  double longest = 0;
  for (std::size_t row = 1; row < jumps.rows.size(); ++row) {
    const double length = value(row, 1) - value(row - 1, 1);
    if (!of_it(row - 1) || !of_it(row) || length <= longest) continue;
    longest = length;
    end = row;
  }
  auto& table = record.table("late-frame", {{"jump", "", measure::whole}, {"t", "s"}, {"x", "m"}});
  for (const std::size_t row : {end - 1, end}) table.add({number, value(row, 1), value(row, 2)});
  record.number("late-frame", 1000 * longest, 2, "ms");
}

inline void jitter(measure::Record& record) {
  using measure::whole;
  auto& table = record.table("jitter", {{"jump", "", whole}, {"t", "s"}, {"plain", "m"}});
  auto& right = record.table("jitter-corrected", {{"jump", "", whole}, {"t", "s"}, {"x", "m"}});
  for (std::size_t first = 0; first < 600; first += 60) {
    const auto keep = [&](auto step, auto& rows) {
      frames::Playback frames{.at = first};
      uneven_run(
          step, jump, 1.1, [&] { return frames.next(); },
          [&](double t, const auto& x) { rows.add({double(first) / 60 + 1, t, x.y()}); });
    };
    keep(plain, table);
    keep(corrected, right);
  }
  std::vector<double> tops;
  for (std::size_t first = 0; first < 600; first += 60) tops.push_back(top(plain, jump, first));
  const auto [lowest, highest] = std::minmax_element(tops.begin(), tops.end());
  record.number("plain-lowest", *lowest, 3, "m");
  record.number("plain-highest", *highest, 3, "m");
  record_late_frame(record, table, double(lowest - tops.begin()) + 1);
  record.number("spring-gentle", widest(corrected, 2), 4, "m");
  record.number("spring-strong", widest(corrected, 20), 2, "m");

  double x = 0, x_previous = -3 * frame, seconds = 0;
  for (const double length : frames::recorded) {
    const scenes::LinearDrag<> ice{.c = 0, .g = 0};
    integrate::stormer_verlet(x, x_previous, 0.0, length, ice);
    seconds += length;
  }
  record.number("puck", x, 4, "m");
  record.number("puck-exact", 3 * seconds, 4, "m");
}
