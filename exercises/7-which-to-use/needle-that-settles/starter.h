// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The needle one frame later, exactly.
/// @param x  where it points, replaced by where it points after the frame
/// @param v  how fast it turns [units of x per s], replaced likewise
/// @param target  where it should point at the start of the frame
/// @param u  velocity of the target, the same during all of the frame [units of x per s]
/// @param omega  frequency of the spring [rad/s]; positive
/// @param h  length of the frame [s]; positive
inline void settle(double& x, double& v, double target, double u, double omega, double h) {
  // Your lines.
}
