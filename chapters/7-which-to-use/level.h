// SPDX-License-Identifier: MIT-0
/// @file
/// The six things that move in one level of a game.
#pragma once
#include <array>

#include "../cast.h"
#include "scenes/toss.h"

/// Steps in a frame that the page tries.
inline constexpr std::array<int, 7> tried_in_a_frame{1, 2, 3, 4, 6, 8, 12};

// [level]
/// The jump by its height alone.
inline const scenes::Toss height_of_jump(jump.start_velocity.y());

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
