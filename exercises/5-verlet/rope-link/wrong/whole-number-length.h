// fails: a link that is too short is pushed apart by the masses of its ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The length goes through a whole number on its way.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  if (both == 0) return;
  const Vec d = b - a;
  const Vec excess = (1 - rest / static_cast<int>(length(d) + 1)) * d;
  a += inverse_a / both * excess;
  b -= inverse_b / both * excess;
}
