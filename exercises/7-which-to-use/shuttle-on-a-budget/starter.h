// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

constexpr int budget = 1200;  // evaluations that a flight may cost

/// Flies a shuttle on.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start [s]
/// @param seconds  how long the flight lasts
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2], mostly a pull to the origin; at most
///                      `budget` times
inline void fly(Vec& x, Vec& v, double t, double seconds, const Acceleration& acceleration) {
  // Your method, and your steps.
}
