// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// How a frame is spent on a rope.
struct Plan {
  int substeps = 1;
  int iterations = 1;  ///< in each substep
};

/// How much too long a rope hangs in the end [m].
/// @param links  each with a point of the same mass at its end
/// @param frame  [s]
/// @param how  a frame is spent
inline double stretch(int links, double frame, const Plan& how) {
  return 0;  // your line; gravity is 9.81 m/s^2
}

/// The cheapest plan that leaves no more than is allowed. A frame costs
/// substeps * (move + iterations * pull) for each link and its point.
/// @param links  of the rope
/// @param frame  [s]
/// @param most  that it may be too long [m]
/// @param move  price of moving a point in one substep [us]
/// @param pull  price of pulling a link once [us]
inline Plan plan(int links, double frame, double most, double move, double pull) {
  return {1, 1};  // your lines
}
