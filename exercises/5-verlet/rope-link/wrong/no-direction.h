// fails: a link that is too long is drawn together by the masses of its ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The difference is not divided by its length.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  if (both == 0) return;
  const Vec d = b - a;
  const double stretch = length(d) - rest;
  a += inverse_a / both * stretch * d;
  b -= inverse_b / both * stretch * d;
}
