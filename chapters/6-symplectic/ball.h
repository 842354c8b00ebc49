// SPDX-License-Identifier: MIT-0
/// @file
/// A ball that should bounce for ever.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "measure/methods.h"
#include "measure/record.h"
#include "measure/run.h"
#include "scenes/linear_drag.h"
#include "shadow.h"

inline constexpr scenes::LinearDrag<> falling{.c = 0};
inline const scenes::State<double> dropped{2, 0};  ///< from two metres, at rest

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
  while (s.v > 0) {
    step(s.x, s.v, 0.0, h, falling);
    top = std::max(top, s.x);
  }
  return top;
}

/// Ground that pushes like a spring, per mass, while the ball is below it, and not at all above.
struct Trampoline {
  double omega = 30;  ///< [1/s]; at sixty steps a second half a radian a step

  double operator()(double x, double, double) const {
    return -9.81 - (x < 0 ? omega * omega * x : 0);
  }
};

/// The greatest height in ten minutes of a ball that is dropped from a metre [m].
/// @param start  where it is dropped, a metre or so [m]
inline double highest_on_a_trampoline(double h, double start = 1) {
  scenes::State<double> s{start, 0};
  double highest = 0;
  for (long n = 0; double(n) * h < 600; ++n) {
    measure::symplectic_euler(s.x, s.v, 0.0, h, Trampoline{});
    highest = std::max(highest, s.x);
  }
  return highest;
}

inline constexpr int lengths = 400;  ///< of a step, that are tried on the trampoline

/// The same in steps of so many lengths between these two shares of a frame, in order of height.
inline std::vector<double> all_highest_on_a_trampoline(double least, double most) {
  std::vector<double> found;
  for (int n = 0; n < lengths; ++n) {
    found.push_back(highest_on_a_trampoline(frame * (least + (most - least) * n / (lengths - 1))));
  }
  std::sort(found.begin(), found.end());
  return found;
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
  record.number("switch-tried", lengths, measure::whole);
}
