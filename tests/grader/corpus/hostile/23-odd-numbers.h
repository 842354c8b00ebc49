// WRONG_ANSWER: answers with NaN, infinity, denormals and minus zero
// SPDX-License-Identifier: MIT-0
#pragma once
#include <limits>
#include "given.h"

inline void step(Vec& x, Vec& v, double t, double h, const Acceleration& acceleration) {
  using Limits = std::numeric_limits<double>;
  x = {Limits::quiet_NaN(), Limits::infinity(), -0.0};
  v = {Limits::denorm_min(), -Limits::infinity(), Limits::signaling_NaN()};
}
