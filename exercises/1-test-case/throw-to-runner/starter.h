// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity with which a ball must leave to meet the runner [m/s].
/// @param from  where the ball leaves [m]
/// @param target  where the runner is at that moment [m]
/// @param runner  velocity of the runner, who keeps it [m/s]
/// @param a  acceleration of the ball, the same all the way [m/s^2]
/// @param time  from the throw to the catch [s], above 0
inline Vec throw_velocity(const Vec& from, const Vec& target, const Vec& runner, const Vec& a,
                          double time) {
  return {};  // Your line.
}
