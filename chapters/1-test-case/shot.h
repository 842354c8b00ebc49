// SPDX-License-Identifier: MIT-0
/// @file
/// The cannonball of chapter 1 in air that slows it.
#pragma once
#include <Eigen/Core>

#include "../cast.h"
#include "integrate/euler.h"
#include "measure/run.h"
#include "scenes/quadratic_drag.h"
#include "scenes/state.h"

/// The air that a cannonball is shot into as a football.
inline constexpr scenes::QuadraticDrag<> heavy_air{.k = 0.01};

/// When and where a shot comes down.
struct Landing {
  double t = 0;  ///< [s]
  double x = 0;  ///< how far away [m]
};

/// Follows a shot in steps of a tenth of a millisecond until it is back at height zero.
/// @param s  the start; above the ground, or on its way up
/// @param observe  called as `observe(t, s)` for the start and each step above the ground
template <class Observe>
Landing land_in_air(scenes::State<Eigen::Vector2d> s, Observe observe) {
  const double h = 1e-4;
  for (long n = 0;; ++n) {
    const double t = double(n) * h;
    observe(t, s);
    const Eigen::Vector2d above = s.x;
    integrate::euler(s.x, s.v, t, h, heavy_air);
    if (s.x.y() < 0) {
      const double part = above.y() / (above.y() - s.x.y());
      return {t + part * h, above.x() + part * (s.x.x() - above.x())};
    }
  }
}

/// How far from its true landing ten steps of a method put a cannonball shot in air [m].
template <class Step>
double off_landing(Step step, const Landing& down) {
  const auto s = measure::after(step, heavy_air, cannonball.start(), down.t / 10, 10);
  return (s.x - Eigen::Vector2d(down.x, 0)).norm();
}
