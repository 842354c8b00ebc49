// Fails: a link that is too long is drawn together by the masses of its ends
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The second end measures from where the first is now.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  const double both = inverse_a + inverse_b;
  if (both == 0) return;
  const auto excess = [&] { return (1 - rest / length(b - a)) * (b - a); };
  a += inverse_a / both * excess();
  b -= inverse_b / both * excess();
}
