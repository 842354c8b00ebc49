// SPDX-License-Identifier: MIT-0
/// @file
/// A rope of points and links whose steps are frames of any length.
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "jitter.h"
#include "rope.h"

/// One frame: each point is moved, then the links are put right.
/// @param move  one of the three steps of jitter.h
/// @param h  length of the frame [s]
/// @param h_previous  that of the frame before [s]
template <class Move>
void frame_of_rope(Rope& rope, Move move, double h, double h_previous, int iterations) {
  for (std::size_t i = 1; i < rope.x.size(); ++i) {
    move(rope.x[i], rope.x_previous[i], 0.0, h, h_previous, gravity);
  }
  for (; iterations > 0; --iterations) {
    for (std::size_t i = 1; i < rope.x.size(); ++i) rope.pull(i);
  }
}

/// How far a rope is stretched that hangs in the recorded frames: the least and the most [share].
template <class Move>
std::pair<double, double> hanging_in_recorded_frames(Move move, int links, int iterations) {
  Rope rope = two_metres(links, {0, -1});
  double least = INFINITY, most = -INFINITY;
  frames::Playback frames;
  for (double t = 0, h = frames.next(), h_previous = h; t < 30;
       t += h, h_previous = h, h = frames.next()) {
    frame_of_rope(rope, move, h, h_previous, iterations);
    least = std::min(least, stretch(rope));
    most = std::max(most, stretch(rope));
  }
  return {least, most};
}
