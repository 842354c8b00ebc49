// SPDX-License-Identifier: MIT-0
/// @file
/// Drag within a step of symplectic Euler: what it does to a leaf and to a spring.
#pragma once
#include <string>
#include <vector>

#include "../cast.h"
#include "measure/compiled.h"
#include "measure/record.h"
#include "measure/stability.h"

/// One way to brake within a step of symplectic Euler.
struct Way {
  const char* name;
  const char* formula;
  const measure::Method& method;
};

inline constexpr Way ways[] = {
    {"explicit last", "(v + ha)(1 − ch)", method::linear_damping_explicit_last},
    {"explicit first", "v(1 − ch) + ha", method::linear_damping_explicit_first},
    {"implicit last", "(v + ha)/(1 + ch)", method::linear_damping_implicit_last},
    {"implicit first", "v/(1 + ch) + ha", method::linear_damping_implicit_first},
    {"exponential last", "(v + ha) exp(−ch)", method::linear_damping_exponential_last},
    {"exponential first", "v exp(−ch) + ha", method::linear_damping_exponential_first},
};

/// The speed at which a leaf ends [m/s].
inline double end_speed(const measure::Method& method, double h) {
  return -measure::after(method, leaf, leaf.start(), h, 2000).v;
}

/// The h omega from which on a spring is lost; infinite from 100 on. It is looked for from below,
/// since some ways hold a spring again at much longer steps.
inline double limit(const measure::Method& method, double zeta) {
  const scenes::Spring<> spring{.zeta = zeta};
  constexpr double by = 0.01;
  for (int n = 1; n <= 10'000; ++n) {
    if (!measure::is_stable(method, spring, n * by)) {
      return measure::stability_limit(method, spring, (n - 1) * by, n * by);
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
  for (const auto& [name, formula, method] : ways) {
    table.add(
        {name, formula, end_speed(method, frame), end_speed(method, 1.0 / 20), limit(method, 1)});
  }

  const auto tenth = [&](const char* name, const measure::Method& method) {
    record.number(name, limit(method, 0.1), 3);
  };
  tenth("tenth-explicit-last", method::linear_damping_explicit_last);
  tenth("tenth-exponential-last", method::linear_damping_exponential_last);
  tenth("tenth-implicit-last", method::linear_damping_implicit_last);

  const double fifth = end_speed(method::linear_damping_exponential_last, frame);
  record.number("leaf-exponential-last", 100 * (1 - fifth / leaf.terminal_speed()), 2, "%");

  std::vector<measure::Column> columns{{"steps per second", "", measure::whole}};
  for (const Way& way : ways) columns.push_back({way.name, "m/s", 4});
  auto& speeds = record.table("terminal", columns);
  for (const int rate : {10, 12, 15, 20, 24, 30, 40, 60, 120, 240}) {
    std::vector<measure::Cell> row{double(rate)};
    for (const Way& way : ways) row.push_back(end_speed(way.method, 1.0 / rate));
    speeds.add(row);
  }
}

inline void damped_limits(measure::Record& record) {
  auto& table =
      record.table("damped", {{"ζ"}, {"Euler"}, {"symplectic Euler"}, {"last"}, {"first"}});
  for (int i = 0; i <= 40; ++i) {
    const double zeta = i / 20.0;
    const auto stable = [&](const measure::Method& method) {
      return measure::stability_limit(method, scenes::Spring<>{.zeta = zeta}, 0, 100);
    };
    table.add({zeta, stable(method::euler), stable(method::symplectic_euler),
               stable(method::linear_damping_implicit_last),
               stable(method::linear_damping_implicit_first)});
  }
  record.number("limit-tenth", limit(method::symplectic_euler, 0.1), 2);
  record.number("limit-half", limit(method::symplectic_euler, 0.5), 2);
  record.number("camera", limit(method::symplectic_euler, 1), 2);
  record.number("euler-limit-tenth", limit(method::euler, 0.1), 1);
  record.number("euler-limit-half", limit(method::euler, 0.5), 1);
  record.number("euler-limit", limit(method::euler, 1), 1);
  record.number("camera-divided", limit(method::linear_damping_implicit_last, 1), 2);
  record.number("door-euler", 1000 * measure::stability_limit(method::euler, door, 1e-6, 1), 3,
                "ms");
  record.number("door-symplectic",
                1000 * measure::stability_limit(method::symplectic_euler, door, 1e-6, 1), 3, "ms");
}
