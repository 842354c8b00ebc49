// SPDX-License-Identifier: MIT-0
/// @file
/// The last scene of chapter 2: the outer planets, in steps of ten days.
#pragma once
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "../cast_of_many.h"
#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"

constexpr double days = 10;
constexpr long planet_steps = 20'000;

using Planets = scenes::OuterSolarSystem<>;

/// Distance between two bodies [AU].
inline double apart(const scenes::State<Planets::Vec>& s, int i, int j) {
  return (s.x.col(i) - s.x.col(j)).norm();
}

/// Keeps every twentieth place of the planets, seen from the sun, and returns where they end.
template <class Step>
scenes::State<Planets::Vec> follow(measure::Record& record, const std::string& name, Step step) {
  std::vector<measure::Column> columns{{"day"}};
  for (int body = 1; body < Planets::bodies; ++body) {
    columns.push_back({std::string(Planets::names[body]) + " x", "AU"});
    columns.push_back({std::string(Planets::names[body]) + " y", "AU"});
  }
  auto& table = record.table(name, columns);
  auto s = outer_planets.start();
  measure::run(step, outer_planets, s, days, planet_steps, [&](double day, const auto& now) {
    if (std::fmod(day, 20 * days) != 0) return;
    std::vector<measure::Cell> row{day};
    for (int body = 1; body < Planets::bodies; ++body) {
      for (int axis = 0; axis < 2; ++axis) row.push_back(now.x(axis, body) - now.x(axis, 0));
    }
    table.add(row);
  });
  return s;
}

/// How far a body is from where it should be, both seen from the sun [AU].
inline double misplaced(const scenes::State<Planets::Vec>& s,
                        const scenes::State<Planets::Vec>& truth, int body) {
  return ((s.x.col(body) - s.x.col(0)) - (truth.x.col(body) - truth.x.col(0))).norm();
}

/// When and how close Jupiter and Saturn pass each other under Euler's method.
inline void meeting(measure::Record& record) {
  double closest = INFINITY, when = 0;
  auto s = outer_planets.start();
  measure::run(measure::euler, outer_planets, s, days, planet_steps,
               [&](double day, const auto& now) {
                 if (apart(now, 1, 2) >= closest) return;
                 closest = apart(now, 1, 2);
                 when = day;
               });
  record.number("meeting-distance", closest, 2, "AU");
  record.number("meeting-year", when / 365.25, 3);
}

inline void planets(measure::Record& record) {
  const auto start = outer_planets.start();
  const auto end = follow(record, "planets-euler", measure::euler);
  follow(record, "planets-true", measure::symplectic_euler);
  record.number("jupiter-start", apart(start, 0, 1), 3, "AU");
  record.number("jupiter-end", apart(end, 0, 1), 3, "AU");
  record.number("saturn-end", apart(end, 0, 2), 3, "AU");
  const auto truth = measure::after(measure::rk4, outer_planets, start, days, planet_steps);
  record.number("uranus-off", misplaced(end, truth, 3), 3, "AU");
  record.number("neptune-off", misplaced(end, truth, 4), 3, "AU");
  record.number("pluto-off", misplaced(end, truth, 5), 2, "AU");
  record.number("jupiter-angle", days * 2 * std::numbers::pi / 4332.6, 3);
  record.number("years", planet_steps * days / 365.25, 3);
  const double energy = outer_planets.energy(start.x, start.v);
  record.number("planets-energy", 100 * (1 - outer_planets.energy(end.x, end.v) / energy), 3, "%");
  meeting(record);
}
