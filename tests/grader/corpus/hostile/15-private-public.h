// WRONG_ANSWER: opens what is private and pokes at the harness
// SPDX-License-Identifier: MIT-0
#define private public
#define class struct
#pragma once
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  struct Opened : harness::Call {
    using harness::Call::Call;
  };
  Opened call(0, {});
  call.answer(1.0);
}
