// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of the Runge-Kutta method that a table describes.
/// @param x  position [m], advanced in place
/// @param v  velocity [m/s], advanced in place
/// @param t  time at the start of the step [s]
/// @param h  step size [s]
/// @param acceleration  callable `(x, v, t) -> Vec` [m/s^2]
/// @param parts  row i, with i numbers: how far stage i goes along each slope before it, in steps;
///   as many rows as the method has stages, one or more
/// @param weights  how much each slope counts at the end; as many as there are rows
inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration,
                 const std::vector<std::vector<double>>& parts,
                 const std::vector<double>& weights) {
  // Your loop.
}
