// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of position Verlet, with drag at the velocity of now.
/// @param x  where it is [m]
/// @param x_previous  where it was one step ago [m]
/// @param a  acceleration at x by everything but the drag [m/s^2]
/// @param c  drag per mass [1/s]: the drag is -c v; may be 0
/// @param h  step size [s]
/// @return where it is one step later [m]
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return x;  // your line or two
}
