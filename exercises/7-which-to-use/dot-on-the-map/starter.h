// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// How much the worst start grows, in the long run, with every step.
/// @param step  moves x and v in place; linear, about a rest that may be anywhere
/// @return the size of the largest eigenvalue of the matrix of the step
inline double growth(const std::function<void(double& x, double& v)>& step) {
  return 0;
}

/// The longest stable step.
/// @param step  moves x and v in place by a step of length h [s]
/// @param most  look no further than this [s]
/// @return the longest h with a growth of at most 1 + 1e-9, to a millionth of itself; or `most`
inline double longest_step(const std::function<void(double& x, double& v, double h)>& step,
                           double most) {
  return 0;
}
