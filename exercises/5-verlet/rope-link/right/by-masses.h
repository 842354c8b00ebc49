// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// With masses again, and the cases apart.
inline void pull(Vec& a, Vec& b, double shortest, double longest, double inverse_a,
                 double inverse_b) {
  if (inverse_a == 0 && inverse_b == 0) return;
  const double now = length(b - a);
  double missing = 0;
  if (now < shortest) missing = shortest - now;
  if (now > longest) missing = longest - now;
  const Vec way = missing * (b - a) / now;
  if (inverse_a == 0) {
    b += way;
  } else if (inverse_b == 0) {
    a -= way;
  } else {
    const double mass_a = 1 / inverse_a, mass_b = 1 / inverse_b, mass = mass_a + mass_b;
    a -= mass_b / mass * way;
    b += mass_a / mass * way;
  }
}
