// SPDX-License-Identifier: MIT-0
/// @file
/// One measurement from many starts, for what one start alone shows by luck.
#pragma once
#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

namespace measure {

/// Measurements at angles evenly around a circle, in order of size.
/// @param count  how many angles
/// @param measured  called as `measured(angle)` [rad]
template <class Measured>
std::vector<double> all_around(int count, Measured measured) {
  std::vector<double> found;
  for (int i = 0; i < count; ++i) found.push_back(measured(2 * std::numbers::pi * i / count));
  std::sort(found.begin(), found.end());
  return found;
}

/// The number that a share of all lies below.
/// @param sorted  in order of size, at least one
/// @param share  from 0 to 1
inline double quantile(const std::vector<double>& sorted, double share) {
  return sorted[std::size_t(share * double(sorted.size() - 1))];
}

/// The one in the middle.
/// @param sorted  in order of size, at least one
inline double median(const std::vector<double>& sorted) {
  return quantile(sorted, 0.5);
}

}  // namespace measure
