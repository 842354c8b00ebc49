// SPDX-License-Identifier: MIT-0
/// @file
/// A ball that should bounce for ever.
#pragma once
#include <algorithm>
#include <string>

#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"
#include "shadow.h"

inline constexpr scenes::LinearDrag<> falling{.c = 0};
inline constexpr scenes::State<double> dropped{2, 0};  ///< from two metres, at rest

// [bounce]
/// A step, and a floor that gives back all of the speed.
template <class Step>
auto on_a_floor(Step step) {
  return [step](auto& x, auto& v, auto t, auto h, const auto& scene) {
    step(x, v, t, h, scene);
    if (x < 0 && v < 0) v = -v;
  };
}
// [bounce]

/// The greatest height after a number of bounces.
template <class Step>
double top_after(Step step, double h, int bounces) {
  auto s = dropped;
  while (bounces > 0) {
    const bool down = s.v < 0;
    on_a_floor(step)(s.x, s.v, 0.0, h, falling);
    bounces -= down && s.v > 0;
  }
  double top = s.x;
  for (; s.v > 0; step(s.x, s.v, 0.0, h, falling)) top = std::max(top, s.x);
  return top;
}

inline void bounces(measure::Record& record) {
  const auto follow = [&](const std::string& name, auto step) {
    auto& table = record.table(name, {{"t", "s"}, {"height", "m"}});
    auto s = dropped;
    measure::run(on_a_floor(step), falling, s, frame, 930,
                 [&](double t, const auto& now) { table.add({t, now.x}); });
    record.number(name + "-top", top_after(step, frame, 10), 3, "m");
  };
  follow("bounce-euler", measure::euler);
  follow("bounce-symplectic", measure::symplectic_euler);
  follow("bounce-exact", measure::constant_acceleration);
}
