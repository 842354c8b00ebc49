// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As position-based dynamics writes it: one multiplier, and each end moves by its inverse mass.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double weights = inverse_a + inverse_b;
  if (!(weights > 0)) return;
  const Vec gradient = (a - b) / length(a - b);
  const double lambda = -(length(a - b) - rest) / weights;
  a += inverse_a * lambda * gradient;
  b += -inverse_b * lambda * gradient;
}
