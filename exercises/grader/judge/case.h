// SPDX-License-Identifier: MIT-0
/// @file
/// A few steps under a force that only the judge knows.
#pragma once
#include "judge/random.h"

namespace judge {

inline constexpr int case_steps = 5;

struct Case {
  Start start;
  double h = 0;  ///< [s]
  harness::Force force;
};

/// Steps so coarse that no two methods agree by being right.
inline Case draw(Random& random) {
  return {random.start(), random.between(0.12, 0.25), random.wild()};
}

}  // namespace judge
