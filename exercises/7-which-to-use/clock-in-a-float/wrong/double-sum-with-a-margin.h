// Fails: after a night the clock is right to the last digit of a double
// Says: a sum in doubles: a tick is rounded, and each addition rounds again, and the sum of so many ticks adds all of that up
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The sum in double, with a margin for its strokes: the roundings are smaller, and there are as
// many.
class Clock {
 public:
  explicit Clock(int rate) : tick_(1.0 / rate) {}
  void tick() {
    before_ = time_;
    time_ += tick_;
  }
  double seconds() const { return time_; }
  bool strikes() const { return std::floor(time_ + 1e-4) > std::floor(before_ + 1e-4); }

 private:
  double tick_, time_ = 0, before_ = 0;
};
