// SPDX-License-Identifier: MIT-0
/// @file
/// What is left of a blow in chapter 4, and how often each step is solved for it.
#pragma once
#include <optional>

#include "../cast.h"
#include "bdf2_spring.h"
#include "integrate/trapezoid.h"
#include "measure/record.h"
#include "struck_nets.h"

/// One solve of the trapezoid rule.
inline constexpr auto trapezoid_once = [](Struck& s, const auto& scene, auto& system) {
  return integrate::trapezoid(s.x, s.v, 0.0, frame, scene, system);
};

/// The trapezoid rule to the end of Newton's method.
inline constexpr auto trapezoid_to_the_end = [](Struck& s, const auto& scene, auto& system) {
  return integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance) > 0;
};

/// Iterations of Newton's method in a step of the trapezoid rule, on average; 0 if one failed.
template <class Scene>
double solves_of_trapezoid(const Scene& scene, double speed, int steps) {
  Struck s = struck(scene, speed);
  auto system = system_of(scene);
  long sum = 0;
  for (int n = 0; n < steps; ++n) {
    const int solves =
        integrate::trapezoid_newton(s.x, s.v, 0.0, frame, scene, system, largest, tolerance);
    if (solves == 0) return 0;
    sum += solves;
  }
  return double(sum) / steps;
}

/// One solve of BDF2, begun with one of backward Euler; for one blow.
inline auto bdf2_once() {
  return [previous = std::optional<Struck>()](Struck& s, const auto& scene, auto& system) mutable {
    const Struck now = s;
    if (previous) {
      s = {(4 * now.x - previous->x) / 3, (4 * now.v - previous->v) / 3};
    }
    const double step = previous ? 2 * frame / 3 : frame;
    previous = now;
    return integrate::backward_euler(s.x, s.v, 0.0, step, scene, system);
  };
}

/// A gentle blow, and what a second leaves of it.
void a_second(measure::Record& record);

/// A hard blow, solved once a step and to the end.
void hard_blow(measure::Record& record);

/// How much each of Newton's iterations changes in one step.
void newton(measure::Record& record);
