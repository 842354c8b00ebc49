// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// One step of backward Euler on a chain of beads of 1 kg each.
/// @param x  how far each bead is from its place [m], advanced in place
/// @param v  velocity of each bead [m/s], advanced in place
/// @param h  step size [s]
/// @param k  stiffness of each spring [N/m], 0 or more: k[i] is between bead i - 1 and bead i, and
/// k[0] between the wall and bead 0; beyond the last bead there is none
inline void step(std::vector<double>& x, std::vector<double>& v, double h,
                 const std::vector<double>& k) {
  // Three diagonals, one elimination, one way back.
}
