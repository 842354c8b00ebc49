// Fails: after a night the clock is right to a millisecond
// Says: a sum in a float: the larger it is, the more of each tick is rounded away
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// As the starter. A whirlwind of lambertjamesd/spellcraft sped up over days and stopped after two
// weeks (its issue 7); the servers of Facepunch/sbox jittered after a day (its issue 8096, 2025).
/// The clock of a server.
class Clock {
 public:
  /// @param rate  ticks a second
  explicit Clock(int rate) : tick_(1.0f / static_cast<float>(rate)) {}

  /// One tick later.
  void tick() {
    before_ = time_;
    time_ += tick_;
  }

  /// The time since the start [s].
  double seconds() const { return time_; }

  /// Whether the last tick completed a whole second.
  bool strikes() const { return std::floor(time_) > std::floor(before_); }

 private:
  float tick_, time_ = 0, before_ = 0;  // [s]
};
