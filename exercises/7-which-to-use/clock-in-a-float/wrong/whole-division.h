// fails: after a night the clock shows the night
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Whole seconds only: both sides of the division are whole.
class Clock {
 public:
  explicit Clock(int rate) : rate_(rate) {}
  void tick() { ++ticks_; }
  double seconds() const { return static_cast<double>(ticks_ / rate_); }
  bool strikes() const { return ticks_ % rate_ == 0; }

 private:
  int rate_;
  std::int64_t ticks_ = 0;
};
