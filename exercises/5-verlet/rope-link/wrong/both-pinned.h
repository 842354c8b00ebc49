// fails: a pinned end stays, and the other goes the whole way
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Nothing over nothing: one such link, and the whole rope is gone.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  const Vec d = b - a;
  const Vec excess = (1 - rest / length(d)) * d;
  a += inverse_a / both * excess;
  b -= inverse_b / both * excess;
}
