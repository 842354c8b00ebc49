// Fails: after a night the clock is right to a millisecond
// Says: 1 / rate was rounded to seven digits, and every tick is wrong by as much: a float?
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// The starter with its time in a double: the tick stays what a float makes of it.
class Clock {
 public:
  explicit Clock(int rate) : tick_(1.0f / static_cast<float>(rate)) {}
  void tick() {
    before_ = time_;
    time_ += tick_;
  }
  double seconds() const { return time_; }
  bool strikes() const { return std::floor(time_) > std::floor(before_); }

 private:
  float tick_;
  double time_ = 0, before_ = 0;
};
