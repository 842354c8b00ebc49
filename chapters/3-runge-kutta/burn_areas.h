// SPDX-License-Identifier: MIT-0
/// @file
/// What one step makes of a push that grows while it lasts.
#pragma once
#include "measure/methods.h"
#include "measure/record.h"
#include "toys.h"

inline constexpr double burn = 4;  ///< one step of the rocket [s]

/// The velocity that the rocket has after one step of four seconds [m/s].
template <class Step>
double velocity_after_burn(Step step) {
  return measure::after(step, engine_on, engine_on.start(), burn, 1).v;
}

/// The push at a moment of the burn [m/s^2].
inline double push(double t) {
  return engine_on(0, 0, t);
}

/// The parabola through the push at the start, in the middle and at the end of the burn [m/s^2].
inline double simpson_parabola(double t) {
  const double s = t / burn, first = push(0), middle = push(burn / 2), last = push(burn);
  return first * (2 * s - 1) * (s - 1) + 4 * middle * s * (1 - s) + last * s * (2 * s - 1);
}

/// The push over the time of the burn, and what three methods take for it.
inline void burn_areas(measure::Record& record) {
  auto& table = record.table(
      "burn-areas",
      {{"t", "s"}, {"push", "m/s²"}, {"Euler", "m/s²"}, {"midpoint", "m/s²"}, {"RK4", "m/s²"}});
  for (int n = 0; n <= 80; ++n) {
    const double t = burn * n / 80;
    table.add({t, push(t), push(0), push(burn / 2), simpson_parabola(t)});
  }
  record.number("burn-step", burn, measure::whole, "s");
  record.number("burn-true", engine_on.exact(burn).v, 3, "m/s");
  record.number("burn-euler", velocity_after_burn(measure::euler), 3, "m/s");
  record.number("burn-midpoint", velocity_after_burn(measure::midpoint), 3, "m/s");
  record.number("burn-rk4", velocity_after_burn(measure::rk4), 3, "m/s");
}
