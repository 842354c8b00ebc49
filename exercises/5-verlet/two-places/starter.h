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
