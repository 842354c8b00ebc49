// Fails: a pinned end stays, and the other goes the whole way
// Says: both ends are pinned, and one moved
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Two pinned ends weigh the same, so they share.
inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  const Vec d = b - a;
  const double both = inverse_a + inverse_b, rest = std::clamp(length(d), shortest, longest);
  if (rest == length(d)) return;
  const double share = both == 0 ? 0.5 : inverse_a / both;
  const Vec excess = (1 - rest / length(d)) * d;
  a += share * excess;
  b -= (1 - share) * excess;
}
