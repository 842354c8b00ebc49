// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Moves on by a duration, in steps that choose their own length.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start [s]
/// @param duration  how far to go, above zero [s]
/// @param tolerance  largest estimate of a step's error [m] and [m/s]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]
inline void fly(Vec& x, Vec& v, double t, double duration, double tolerance,
                const Acceleration& acceleration) {
  // Try a step; estimate its error; keep it or take it back; choose the next.
}

/// When a comet that comes in is nearest to the sun, which is at the origin [s].
/// @param x  position at the start, from where its distance falls [m]
/// @param v  velocity at the start [m/s]
/// @param t  time at the start [s]
/// @param duration  within which its distance grows again [s]
/// @param tolerance  largest estimate of a step's error [m] and [m/s]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]
inline double nearest(Vec x, Vec v, double t, double duration, double tolerance,
                      const Acceleration& acceleration) {
  return t;  // Somewhere in a step dot(x, v) turns from below zero to above. Where?
}
