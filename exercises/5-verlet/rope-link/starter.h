// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Moves the ends of a link until it is as long as it may be.
/// @param a, b  the two ends [m], moved in place; never both in one place
/// @param shortest, longest  how long the link may be [m], 0 or more; between them nothing moves
/// @param inverse_a, inverse_b  one over the mass of each end [1/kg]; 0 for an end that is pinned
inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  // Your lines.
}
