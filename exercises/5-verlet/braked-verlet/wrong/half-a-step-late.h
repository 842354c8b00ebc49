// fails: a light damper leaves the limit of the step at h omega = 2
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Position Verlet as it is.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return x + (1 - c * h) * (x - x_previous) + h * h * a;
}
