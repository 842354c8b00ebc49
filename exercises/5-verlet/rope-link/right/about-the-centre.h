// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The point that stays, and each end at its new distance from it.
inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  const Vec d = b - a;
  const double now = std::hypot(d.x, d.y, d.z);
  if ((now >= shortest && now <= longest) || inverse_a + inverse_b <= 0) return;
  const double share = inverse_a / (inverse_a + inverse_b);
  const Vec still = a + share * d;
  const Vec link = d * ((now < shortest ? shortest : longest) / now);
  a = still - share * link;
  b = still + (1 - share) * link;
}
