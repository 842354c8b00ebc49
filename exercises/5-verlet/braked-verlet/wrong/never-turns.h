// fails: a critical damper and a heavy one leave it there, too
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A factor that is kept from below zero, as engines do: no ringing, but the limit stays short.
inline Vec next_place(const Vec& x, const Vec& x_previous, const Vec& a, double c, double h) {
  return x + std::max(0.0, 1 - c * h) * (x - x_previous) + h * h * a;
}
