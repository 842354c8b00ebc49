// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The velocity of the air [m/s] at a place [m] and a time [s]. Each call is counted.
using Wind = std::function<Vec(const Vec& x, double t)>;

/// One frame of a leaf, x'' = c (wind - x').
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the frame [s]
/// @param h  length of the frame [s]
/// @param c  how fast a leaf takes on the wind's velocity [1/s]; c h may be well above 2
/// @param wind  may be asked once
inline void frame(Vec& x, Vec& v, double t, double h, double c, const Wind& wind) {
  // Where and when do you ask? And what do you divide by?
}
