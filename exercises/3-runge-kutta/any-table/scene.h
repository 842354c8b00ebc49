// SPDX-License-Identifier: MIT-0
/// @file
/// Tables of any numbers, and bodies that they move.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../table.h"
#include "harness.h"
#include "judge/random.h"
#include "judge/rounding.h"

namespace judge::any_table {

/// A table of any rows and weights, whatever they add up to; one row in four adds up to zero, and
/// so do one table's weights in four, as those of an error estimate do.
inline ButcherTable of_any_numbers(Random& random) {
  const auto stages = static_cast<std::size_t>(random.anywhere(harness_bounds::rows));
  ButcherTable table{"the method of a table with " + std::to_string(stages) + " stages", {}, {}};
  for (std::size_t i = 0; i < stages; ++i) {
    table.parts.emplace_back();
    for (std::size_t j = 0; j < i; ++j)
      table.parts[i].push_back(random.anywhere(harness_bounds::part));
    if (i > 1 && random.whole(0, 3) == 0) {
      table.parts[i].back() = 0;
      for (std::size_t j = 0; j + 1 < i; ++j) table.parts[i].back() -= table.parts[i][j];
    }
    table.weights.push_back(random.anywhere(harness_bounds::weight));
  }
  if (random.whole(0, 3) > 0) return table;
  table.weights.back() = 0;
  for (std::size_t i = 0; i + 1 < stages; ++i) table.weights.back() -= table.weights[i];
  return table;
}

/// A push that is never large, nor steep: so it is known how an error grows from stage to stage.
struct Gentle {
  Vec at;  ///< angles at the origin

  static constexpr double most = 1.8;   ///< [m/s^2]
  static constexpr double slope = 4.0;  ///< an error in place, velocity and time grows so far

  Vec operator()(const Vec& x, const Vec& v, double t) const {
    return {std::sin(at.x + x.y + v.z + t), std::sin(at.y + x.z + v.x + t),
            std::sin(at.z + x.x + v.y + t)};
  }
};

/// Some steps of a body.
struct Scene {
  Start start;
  double h = 0;
  int steps = 1;
  Acceleration acceleration;
  Tolerance tolerance;
  std::string asked;

  static Start anywhere(Random& random) {
    return {random.vector_anywhere(harness_bounds::place),
            random.vector_anywhere(harness_bounds::velocity), 0};
  }
};

/// The rounding of one step under a gentle push. Each stage is rounded as far as the numbers go
/// that it sums up, and carries on what was wrong with those before it.
inline Tolerance rounding_of_a_step(const ButcherTable& table, const Start& start, double h) {
  const auto sum = [&](double first, const std::vector<double>& row, const auto& of_stage) {
    for (std::size_t j = 0; j < row.size(); ++j) first += h * std::abs(row[j]) * of_stage(j);
    return first;
  };
  std::vector<double> fastest, wrong;
  const auto add = [&](const std::vector<double>& row) {
    const auto velocity = [&](std::size_t j) { return fastest[j]; };
    const double place = sum(length(start.x), row, velocity);
    const double time = sum(std::abs(start.t), row, [](std::size_t) { return 1.0; });
    const double v = sum(length(start.v), row, [](std::size_t) { return Gentle::most; });
    const double own = rounding(std::max({place, time, v})).value;
    const double all = sum(own, row, [&](std::size_t j) { return Gentle::slope * wrong[j]; });
    fastest.push_back(v);
    wrong.push_back(all);
  };
  for (const std::vector<double>& row : table.parts) add(row);
  add(table.weights);
  return {wrong.back(),
          "rounding: 200 operations a stage, each wrong by at most half a unit in the sixteenth "
          "digit of what they sum up, and carried on from stage to stage"};
}

}  // namespace judge::any_table
