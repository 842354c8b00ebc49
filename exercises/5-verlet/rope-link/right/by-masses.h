// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// With masses again, and the cases apart.
inline void pull(Vec& a, Vec& b, double rest, double inverse_a, double inverse_b) {
  if (inverse_a == 0 && inverse_b == 0) return;
  const Vec direction = (b - a) / length(b - a);
  const double missing = rest - length(b - a);
  if (inverse_a == 0) {
    b += missing * direction;
  } else if (inverse_b == 0) {
    a -= missing * direction;
  } else {
    const double mass_a = 1 / inverse_a, mass_b = 1 / inverse_b, mass = mass_a + mass_b;
    a -= missing * (mass_b / mass) * direction;
    b += missing * (mass_a / mass) * direction;
  }
}
