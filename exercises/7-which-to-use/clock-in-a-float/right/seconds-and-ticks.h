// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Whole seconds, and the ticks of the one that has begun.
class Clock {
 public:
  explicit Clock(int rate) : rate_(rate) {}

  void tick() {
    if (++ticks_ < rate_) return;
    ticks_ = 0;
    ++seconds_;
  }

  double seconds() const {
    return static_cast<double>(seconds_) + static_cast<double>(ticks_) / rate_;
  }

  bool strikes() const { return seconds_ > 0 && ticks_ == 0; }

 private:
  int rate_, ticks_ = 0;
  long seconds_ = 0;
};
