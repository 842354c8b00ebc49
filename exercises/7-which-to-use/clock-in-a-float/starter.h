// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

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

  /// Whether the last tick completed a whole second; before the first one, nothing has.
  bool strikes() const { return std::floor(time_) > std::floor(before_); }

 private:
  float tick_, time_ = 0, before_ = 0;  // [s]
};
