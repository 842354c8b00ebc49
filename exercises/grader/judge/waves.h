// SPDX-License-Identifier: MIT-0
/// @file
/// A push that nobody can learn by asking: for tests that pay for few evaluations.
#pragma once
#include <array>

#include "judge/random.h"

namespace judge {

/// A smooth acceleration of place and time, the sum of many waves. With constants by the hundred,
/// it costs less to follow than to find out, and only the judge can work it out for nothing.
class Waves {
 public:
  /// @param strength  root of its mean square [m/s^2]
  /// @param scale  how far it is from one crest to the next, at the least [m]
  /// @param seconds  and how long, at the least [s]
  Waves(Random& random, double strength, double scale, double seconds);

  /// @return  the acceleration [m/s^2]
  Vec operator()(const Vec& x, double t) const;

 private:
  struct Wave {
    Vec push, along;          // [m/s^2], [1/m]
    double rate = 0, at = 0;  // [1/s], the angle at the origin
  };
  std::array<Wave, 24> waves_;
};

}  // namespace judge
