// fails: after days a minute is as long as the first one
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Ticks are counted, but in a float: from 16 777 216 on, one more is none.
class Clock {
 public:
  explicit Clock(int rate) : rate_(rate) {}
  void tick() { ticks_ += 1; }
  double seconds() const { return static_cast<double>(ticks_) / rate_; }
  bool strikes() const { return std::fmod(ticks_, static_cast<float>(rate_)) == 0; }

 private:
  int rate_;
  float ticks_ = 0;
};
