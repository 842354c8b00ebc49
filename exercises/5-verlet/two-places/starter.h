// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Where a spark is one step later, by position Verlet.
/// @param x  where it is [m]
/// @param x_previous  where it was one step ago [m]
/// @param a  acceleration at x [m/s^2]
/// @param h  step size [s]
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double h) {
  return x;  // your line
}

/// Where a spark that starts now would have been one step ago.
/// @param x  where it starts [m]
/// @param v  its velocity at the start [m/s]
/// @param a  acceleration at the start [m/s^2]
/// @param h  step size [s]
inline Vec place_before(const Vec& x, const Vec& v, const Vec& a, double h) {
  return x;  // your line
}

/// Lets a spark that is below the floor bounce off it, wherever it was a step ago: a floor may
/// rise. One that is not is left alone.
/// @param x  where it is [m]; y points up
/// @param x_previous  where it was one step ago [m]
/// @param floor  height of the floor [m]
/// @param restitution  how much of its speed up and down it keeps, 0 to 1
inline void bounce(Vec& x, Vec& x_previous, double floor, double restitution) {
  // your lines
}
