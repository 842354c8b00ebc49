// SPDX-License-Identifier: MIT-0
#pragma once

void (Clock::* const wanted_tick)() = &Clock::tick;
double (Clock::* const wanted_seconds)() const = &Clock::seconds;
bool (Clock::* const wanted_strikes)() const = &Clock::strikes;

// Function 1: whether a new clock strikes. Function 0: rate, ticks to wait for, seconds to listen
// for. Answers with the time then, and for each second how often it struck and at which tick the
// last time; and with the time at the end.
void answer(harness::Call& call) {
  const int rate = call.whole_number();
  Clock clock(rate);
  if (call.function() == 1) return call.answer((clock.*wanted_strikes)());
  const int ticks = call.whole_number();
  for (int n = 0; n < ticks; ++n) (clock.*wanted_tick)();
  call.answer((clock.*wanted_seconds)());
  const int seconds = call.whole_number();
  for (int second = 0; second < seconds; ++second) {
    int strokes = 0, last = 0;
    for (int n = 1; n <= rate; ++n) {
      (clock.*wanted_tick)();
      if (!(clock.*wanted_strikes)()) continue;
      ++strokes;
      last = n;
    }
    call.answer(strokes);
    call.answer(last);
  }
  call.answer((clock.*wanted_seconds)());
}
