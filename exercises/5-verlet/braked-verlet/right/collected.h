// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// All that is known over the factor of what is not.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return (4 * x - (2 - c * h) * x_previous + 2 * h * h * a) / (2 + c * h);
}
