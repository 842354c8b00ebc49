// Fails: after a night the clock is right to a millisecond
// Says: each tick is cut to whole microseconds
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The fraction of a microsecond is cut off at every tick.
class Clock {
 public:
  explicit Clock(int rate) : tick_(1000000 / rate) {}
  void tick() {
    before_ = time_;
    time_ += tick_;
  }
  double seconds() const { return static_cast<double>(time_) / 1000000; }
  bool strikes() const { return time_ / 1000000 > before_ / 1000000; }

 private:
  std::int64_t tick_, time_ = 0, before_ = 0;  // [us]
};
