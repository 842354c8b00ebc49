// SPDX-License-Identifier: MIT-0
/// @file
/// Drag within a step of symplectic Euler: what it does to a leaf and to a spring.
#pragma once
#include <string>
#include <vector>

#include "measure/linear_methods.h"
#include "measure/record.h"
#include "measure/stability.h"
#include "scenes/linear_drag.h"
#include "scenes/spring.h"

inline constexpr scenes::LinearDrag<> leaf{.c = 2};

/// Calls `visit(name, formula, step)` for each of the six ways.
template <class Visit>
void for_each_way(Visit visit) {
  visit("explicit last", "(v + ha)(1 − ch)", measure::linear_damping_explicit_last);
  visit("explicit first", "v(1 − ch) + ha", measure::linear_damping_explicit_first);
  visit("implicit last", "(v + ha)/(1 + ch)", measure::linear_damping_implicit_last);
  visit("implicit first", "v/(1 + ch) + ha", measure::linear_damping_implicit_first);
  visit("exponential last", "(v + ha) exp(−ch)", measure::linear_damping_exponential_last);
  visit("exponential first", "v exp(−ch) + ha", measure::linear_damping_exponential_first);
}

/// The speed at which a leaf ends [m/s].
template <class Step>
double end_speed(Step step, double h) {
  return -measure::after(step, leaf, leaf.start(), h, 2000).v;
}

/// The h omega from which on a spring is lost; infinite from 100 on. It is looked for from below,
/// since some ways hold a spring again at much longer steps.
template <class Step>
double limit(Step step, double zeta) {
  const scenes::Spring<> spring{.zeta = zeta};
  constexpr double by = 0.01;
  for (int n = 1; n <= 10'000; ++n) {
    if (measure::spectral_radius(step, spring, n * by) > 1 + 1e-12) {
      return measure::stability_limit(step, spring, (n - 1) * by, n * by);
    }
  }
  return INFINITY;
}

inline void six_ways(measure::Record& record) {
  record.number("leaf-end", leaf.terminal_speed(), 4, "m/s");
  auto& table = record.table("ways", {{"way"},
                                      {"new velocity"},
                                      {"at 60 Hz", "m/s", 5},
                                      {"at 20 Hz", "m/s", 5},
                                      {"limit at ζ = 1", "", 4}});
  for_each_way([&](auto name, auto formula, auto step) {
    table.add(
        {name, formula, end_speed(step, 1.0 / 60), end_speed(step, 1.0 / 20), limit(step, 1)});
  });

  const auto tenth = [&](const char* name, auto step) {
    record.number(name, limit(step, 0.1), 3);
  };
  tenth("tenth-explicit-last", measure::linear_damping_explicit_last);
  tenth("tenth-exponential-last", measure::linear_damping_exponential_last);
  tenth("tenth-implicit-last", measure::linear_damping_implicit_last);

  const double fifth = end_speed(measure::linear_damping_exponential_last, frame);
  record.number("leaf-exponential-last", 100 * (1 - fifth / leaf.terminal_speed()), 2, "%");

  std::vector<measure::Column> columns{{"steps per second", "", measure::whole}};
  for_each_way([&](auto name, auto, auto) { columns.push_back({name, "m/s", 4}); });
  auto& speeds = record.table("terminal", columns);
  for (const int rate : {10, 12, 15, 20, 24, 30, 40, 60, 120, 240}) {
    std::vector<measure::Cell> row{double(rate)};
    for_each_way([&](auto, auto, auto step) { row.push_back(end_speed(step, 1.0 / rate)); });
    speeds.add(row);
  }
}

inline void damped_limits(measure::Record& record) {
  auto& table =
      record.table("damped", {{"ζ"}, {"Euler"}, {"symplectic Euler"}, {"last"}, {"first"}});
  for (int i = 0; i <= 40; ++i) {
    const double zeta = i / 20.0;
    const auto stable = [&](auto step) {
      return measure::stability_limit(step, scenes::Spring<>{.zeta = zeta}, 0, 100);
    };
    table.add({zeta, stable(measure::euler), stable(measure::symplectic_euler),
               stable(measure::linear_damping_implicit_last),
               stable(measure::linear_damping_implicit_first)});
  }
  record.number("camera", limit(measure::symplectic_euler, 1), 2);
  record.number("camera-divided", limit(measure::linear_damping_implicit_last, 1), 2);
  constexpr scenes::Spring<> door{.omega = 10, .zeta = 5};
  record.number("door-euler", 1000 * measure::stability_limit(measure::euler, door, 1e-6, 1), 3,
                "ms");
  record.number("door-symplectic",
                1000 * measure::stability_limit(measure::symplectic_euler, door, 1e-6, 1), 3, "ms");
}
