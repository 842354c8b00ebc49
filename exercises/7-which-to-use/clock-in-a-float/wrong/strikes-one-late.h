// fails: it strikes at each whole second, and never in between
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

class Clock {
 public:
  explicit Clock(int rate) : rate_(rate) {}
  void tick() { ++ticks_; }
  double seconds() const { return static_cast<double>(ticks_) / rate_; }
  bool strikes() const { return (ticks_ - 1) % rate_ == 0; }

 private:
  int rate_;
  std::int64_t ticks_ = 0;
};
