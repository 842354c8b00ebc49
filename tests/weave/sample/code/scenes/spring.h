// SPDX-License-Identifier: MIT-0
#pragma once

namespace scenes {

/// A mass on a spring: x'' = -omega^2 x.
template <class Real = double>
struct Spring {
  Real omega = 1;  ///< natural frequency [rad/s]

  /// The acceleration.
  template <class Vec, class Time>
  constexpr Vec operator()(const Vec& x, const Vec&, Time) const {
    return (-omega * omega) * x;
  }
};

}  // namespace scenes
