// SPDX-License-Identifier: MIT-0
/// @file
/// BDF2 on the springs of chapter 4: backward Euler that remembers one step more.
#pragma once
#include "../cast.h"
#include "integrate/backward_euler_spring.h"
#include "scenes/state.h"

/// What one step of backward Euler leaves of the energy of an undamped spring.
constexpr double left_in_a_step(double homega) {
  return 1 / (1 + homega * homega);
}

/// One step of BDF2 on a damped spring.
/// @param s  the state, advanced in place
/// @param previous  the state one step before, advanced in place
/// @param h  step size [s]; the same as in the step before
inline void bdf2_spring(scenes::State<double>& s, scenes::State<double>& previous, double h,
                        double omega, double zeta) {
  // [move]
  double x = (4 * s.x - previous.x) / 3, v = (4 * s.v - previous.v) / 3;
  integrate::backward_euler_spring(x, v, 2 * h / 3, omega, zeta);
  previous = s;
  s = {x, v};
  // [move]
}

/// The state of a spring after some frames of BDF2, begun with a step of backward Euler.
inline scenes::State<double> after_bdf2(const scenes::Spring<>& spring, double h, int steps) {
  auto previous = spring.start(), s = previous;
  integrate::backward_euler_spring(s.x, s.v, h, spring.omega, spring.zeta);
  for (int n = 1; n < steps; ++n) bdf2_spring(s, previous, h, spring.omega, spring.zeta);
  return s;
}

/// What a second of BDF2 leaves of the energy of an undamped spring.
inline double left_by_bdf2(double omega) {
  const scenes::Spring<> spring{.omega = omega};
  const auto start = spring.start(), end = after_bdf2(spring, frame, 60);
  return spring.energy(end.x, end.v) / spring.energy(start.x, start.v);
}
