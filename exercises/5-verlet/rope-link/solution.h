// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// Moves the ends of a link until it is as long as it may be.
inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  const Vec d = b - a;
  const double both = inverse_a + inverse_b, rest = std::clamp(length(d), shortest, longest);
  if (both == 0 || rest == length(d)) return;
  const Vec excess = (1 - rest / length(d)) * d;
  a += inverse_a / both * excess;
  b -= inverse_b / both * excess;
}
