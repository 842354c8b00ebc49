// Fails: after a night the clock is right to a millisecond
// Says: each tick is cut to whole milliseconds
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The fraction of a millisecond is cut off at every tick: four per cent slow at 60 a second.
// Shipped in space-wizards/RobustToolbox until its pull request 4300 (2023).
class Clock {
 public:
  explicit Clock(int rate) : tick_(1000 / rate) {}
  void tick() {
    before_ = time_;
    time_ += tick_;
  }
  double seconds() const { return static_cast<double>(time_) / 1000; }
  bool strikes() const { return time_ / 1000 > before_ / 1000; }

 private:
  std::int64_t tick_, time_ = 0, before_ = 0;  // [ms]
};
