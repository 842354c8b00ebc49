// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As position-based dynamics writes it: one inequality for each bound, and each end moves by its
// inverse mass.
inline void hold(Vec& a, Vec& b, double by, double inverse_a, double inverse_b) {
  const double weights = inverse_a + inverse_b;
  if (!(weights > 0)) return;
  const Vec gradient = (a - b) / length(a - b);
  const double lambda = -by / weights;
  a += inverse_a * lambda * gradient;
  b += -inverse_b * lambda * gradient;
}

inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  const double now = length(a - b);
  if (now > longest) hold(a, b, now - longest, inverse_a, inverse_b);
  if (now < shortest) hold(a, b, now - shortest, inverse_a, inverse_b);
}
