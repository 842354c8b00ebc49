// SPDX-License-Identifier: MIT-0
/// @file
/// Where a thing is and how fast it moves.
#pragma once

/// The scenes to integrate: each is an acceleration, a start, and what is known about the answer.
///
/// A scene is a plain struct. Calling it as `scene(x, v, t)` gives the acceleration. `start()` is a
/// start that suits the scene. Where there is an exact solution, `exact(t)` is the state at time t
/// that follows from `start()`; where something is conserved, it has a member for that.
///
/// The exact solutions call the C library's sine, exponential and logarithm and may differ in the
/// last bit from one machine to the next. No acceleration does.
namespace scenes {

/// Position and velocity of everything in a scene.
/// @tparam Vec  a number, or any vector type
template <class Vec>
struct State {
  Vec x;  ///< position [m, or the unit of the scene]
  Vec v;  ///< velocity [units of x per s]
};

}  // namespace scenes
