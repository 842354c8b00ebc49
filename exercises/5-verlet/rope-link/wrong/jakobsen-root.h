// fails: a link that is too long is drawn together by the masses of its ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The square root of Jakobsen's talk of 2001, approximated: near where the stretch is small.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  if (both == 0) return;
  const Vec d = b - a;
  const Vec excess = (1 - 2 * rest * rest / (dot(d, d) + rest * rest)) * d;
  a += inverse_a / both * excess;
  b -= inverse_b / both * excess;
}
