// SPDX-License-Identifier: MIT-0
#pragma once
#include "given.h"

// A double counts without rounding up to nine million billion.
struct Clock {
  explicit Clock(int ticks_a_second) : tick_length(1.0 / ticks_a_second), rate(ticks_a_second) {}

  void tick() { count += 1; }
  double seconds() const { return count * tick_length; }
  bool strikes() const { return count > 0 && std::fmod(count, rate) == 0; }

  double tick_length, rate, count = 0;
};
