// SPDX-License-Identifier: MIT-0
/// @file
/// Where the velocities of leapfrog lie between the places.
#pragma once
#include <vector>

#include "measure/methods.h"
#include "measure/run.h"
#include "scenes/spring.h"

/// The velocities about a kick: with which the place came and with which it goes on, and velocity
/// Verlet's at the same moment [s, m/s].
struct Kick {
  double t, before, after, verlet;
};

/// The kicks of symplectic Euler when it is started half a kick back.
inline std::vector<Kick> kicks_of(const scenes::Spring<>& spring, double h, int steps) {
  std::vector<Kick> seen;
  auto whole = spring.start(), s = whole;
  measure::run(measure::velocity_verlet, spring, whole, h, steps, [&](double t, const auto& now) {
    seen.push_back({.t = t, .before = 0, .after = 0, .verlet = now.v});
  });
  s.v -= h / 2 * spring(s.x, s.v, 0.0);
  for (Kick& kick : seen) {
    kick.before = s.v;
    measure::symplectic_euler(s.x, s.v, kick.t, h, spring);
    kick.after = s.v;
  }
  return seen;
}
