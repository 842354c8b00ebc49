// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

/// The clock of a server. It counts, and divides only when it is asked.
class Clock {
 public:
  explicit Clock(int rate) : rate_(rate) {}

  void tick() { ++ticks_; }

  double seconds() const { return static_cast<double>(ticks_) / rate_; }

  bool strikes() const { return ticks_ > 0 && ticks_ % rate_ == 0; }

 private:
  int rate_;  // [1/s]
  std::int64_t ticks_ = 0;
};
