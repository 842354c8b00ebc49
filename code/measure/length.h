// SPDX-License-Identifier: MIT-0
/// @file
/// The length of a vector or a number.
#pragma once
#include <cmath>
#include <type_traits>

namespace measure {

/// The length of a vector, or the size of a number.
template <class Vec>
double length(const Vec& x) {
  if constexpr (std::is_arithmetic_v<Vec>) {
    return static_cast<double>(std::abs(x));
  } else {
    return static_cast<double>(x.norm());
  }
}

}  // namespace measure
