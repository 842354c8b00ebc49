// SPDX-License-Identifier: MIT-0
/// @file
/// The six things that move in one level of a game.
#pragma once
#include "../cast.h"

/// A ball in a vacuum, thrown straight up.
struct Ball : scenes::LinearDrag<> {
  /// Energy per unit mass, which is conserved [J/kg].
  double energy(double x, double v) const { return v * v / 2 + g * x; }
};

// [level]
/// The jump by its height alone.
inline const Ball height_of_jump{{.c = 0, .v0 = jump.start_velocity.y()}};

/// Calls `visit(name, scene, seconds)` for each thing, with how long it is watched.
template <class Visit>
void for_each_thing(Visit visit) {
  visit("jump", height_of_jump, 1);
  visit("leaf", leaf, 2);
  visit("suspension", suspension, 1);
  visit("hatch", hatch, 1);
  visit("lamp", lamp, 10);
  visit("shuttle", shuttle, 8);
}
// [level]
