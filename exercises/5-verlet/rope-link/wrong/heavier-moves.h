// fails: a link that is too long is drawn together by the masses of its ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The inverse mass is taken for the mass.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  if (both == 0) return;
  const Vec d = b - a;
  const Vec excess = (1 - rest / length(d)) * d;
  a += inverse_b / both * excess;
  b -= inverse_a / both * excess;
}
