// fails: on a damped spring half the step leaves a quarter of the error
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The known half alone.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return x + (1 - c * h / 2) * (x - x_previous) + h * h * a;
}
