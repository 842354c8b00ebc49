// Fails: a link that is too long is drawn together to its longest, by the masses of its ends
// Says: the second end was measured from where the first one is now, and not was
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The second end measures from where the first is now.
inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  const double both = inverse_a + inverse_b, rest = std::clamp(length(b - a), shortest, longest);
  if (both == 0 || rest == length(b - a)) return;
  const auto excess = [&] { return (1 - rest / length(b - a)) * (b - a); };
  a += inverse_a / both * excess();
  b -= inverse_b / both * excess();
}
