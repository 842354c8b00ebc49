// fails: after a night the clock shows the night
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Starts again at every hour, so that the float stays small; nobody adds up the hours.
class Clock {
 public:
  explicit Clock(int rate) : rate_(rate) {}
  void tick() { ticks_ = (ticks_ + 1) % (3600 * rate_); }
  double seconds() const { return static_cast<double>(ticks_) / rate_; }
  bool strikes() const { return ticks_ % rate_ == 0; }

 private:
  int rate_, ticks_ = 0;
};
