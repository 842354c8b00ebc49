// Fails: after a night the clock is right to a millisecond
// Says: each tick is cut to whole nanoseconds
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Whole numbers, of a unit that no tick is a whole number of.
class Clock {
 public:
  explicit Clock(int rate) : tick_(1'000'000'000 / rate) {}
  void tick() {
    before_ = time_;
    time_ += tick_;
  }
  double seconds() const { return static_cast<double>(time_) * 1e-9; }
  bool strikes() const { return time_ / 1'000'000'000 > before_ / 1'000'000'000; }

 private:
  std::int64_t tick_, time_ = 0, before_ = 0;  // [ns]
};
