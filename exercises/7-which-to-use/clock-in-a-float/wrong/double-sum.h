// Fails: the clock strikes at each whole second, and never in between
// Says: a sum in doubles: a tick is rounded, and each addition rounds again, and the sum of so many ticks adds all of that up
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The sum in double: the roundings are smaller, and there are as many.
class Clock {
 public:
  explicit Clock(int rate) : tick_(1.0 / rate) {}
  void tick() {
    before_ = time_;
    time_ += tick_;
  }
  double seconds() const { return time_; }
  bool strikes() const { return std::floor(time_) > std::floor(before_); }

 private:
  double tick_, time_ = 0, before_ = 0;
};
