// SPDX-License-Identifier: MIT-0
/// @file
/// The distance of two right answers that differ only in the order of their sums.
#pragma once
#include <limits>
#include <string>

namespace judge {

/// A tolerance and where it comes from.
struct Tolerance {
  double value = 0;
  std::string from;
};

/// Rounding in `steps` steps. A step of any method in this book has fewer than 200 operations, each
/// wrong by half a unit in the last place of numbers about as large as `size`; a force that is bent
/// lets errors grow by a factor of less than 40 in the few steps that a test takes.
inline Tolerance rounding(int steps, double size) {
  constexpr double per_step = 200 * 0.5 * 40 * std::numeric_limits<double>::epsilon();
  return {per_step * steps * size,
          "rounding: 200 operations a step, each wrong by at most half a unit in the sixteenth "
          "digit, and a growth of 40 at most"};
}

/// Rounding of one number from a short formula: 200 operations.
inline Tolerance rounding(double size) {
  return {200 * 0.5 * std::numeric_limits<double>::epsilon() * size,
          "rounding: 200 operations, each wrong by at most half a unit in the sixteenth digit"};
}

}  // namespace judge
