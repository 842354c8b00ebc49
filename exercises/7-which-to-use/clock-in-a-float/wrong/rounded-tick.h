// fails: after a night the clock shows the night
// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// Counted in whole numbers and multiplied by a tick of 24 bits, as the clock of the Patriot
// batteries was: a third of a second off after 100 hours (GAO report IMTEC-92-26, 1992).
class Clock {
 public:
  explicit Clock(int rate) : rate_(rate), tick_(1.0f / static_cast<float>(rate)) {}
  void tick() { ++ticks_; }
  double seconds() const { return static_cast<double>(ticks_) * tick_; }
  bool strikes() const { return ticks_ % rate_ == 0; }

 private:
  int rate_;
  float tick_;
  std::int64_t ticks_ = 0;
};
