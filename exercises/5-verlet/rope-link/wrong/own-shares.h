// fails: a link that is too long is drawn together by the masses of its ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  if (both == 0) return;
  const Vec d = b - a;
  const Vec excess = (1 - rest / length(d)) * d;
  a += inverse_a * excess;
  b -= inverse_b * excess;
}
