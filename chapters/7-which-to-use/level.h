// SPDX-License-Identifier: MIT-0
/// @file
/// The six things that move in one level of a game.
#pragma once
#include <cmath>
#include <numbers>

#include "entrants.h"
#include "measure/error.h"
#include "scenes/linear_drag.h"
#include "scenes/orbit.h"
#include "scenes/pendulum.h"
#include "scenes/spring.h"

inline constexpr double frame = 1.0 / 60;  ///< [s]

/// A ball in a vacuum, thrown straight up.
struct Ball : scenes::LinearDrag<> {
  /// Energy per unit mass, which is conserved [J/kg].
  double energy(double x, double v) const { return v * v / 2 + g * x; }
};

inline constexpr double eight_seconds = 2 * std::numbers::pi / 8;  ///< once in eight seconds

// [level]
inline constexpr Ball jump{{.c = 0, .v0 = 5}};
inline constexpr scenes::LinearDrag<> leaf{.c = 2};
inline constexpr scenes::Spring<> suspension{.omega = 20, .zeta = 0.1, .x0 = 0.1};
inline constexpr scenes::Spring<> hatch{.omega = 60, .zeta = 2, .x0 = 1};
inline constexpr scenes::Pendulum<> lamp{.length = 1, .angle = 1};
inline constexpr scenes::Orbit<> shuttle{
    .eccentricity = 0.6, .semi_major = 10, .mu = 1000 * eight_seconds * eight_seconds};

/// Calls `visit(name, scene, seconds)` for each thing, with how long it is watched.
template <class Visit>
void for_each_thing(Visit visit) {
  visit("jump", jump, 1);
  visit("leaf", leaf, 2);
  visit("suspension", suspension, 1);
  visit("hatch", hatch, 1);
  visit("lamp", lamp, 10);
  visit("shuttle", shuttle, 8);
}
// [level]

/// The largest distance from where a thing should be [m]; infinite from a kilometre on.
template <class Scene>
double off(const measure::Method& method, const Scene& scene, double h, double seconds) {
  const double error = measure::largest_error(method, scene, h, std::lround(seconds / h)).position;
  return error < 1000 ? error : INFINITY;
}
